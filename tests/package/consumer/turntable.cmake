# Included by the project that the README shows: with Boost, the example that simulates.
find_package(Boost REQUIRED)
add_executable(turntable EXCLUDE_FROM_ALL turntable.cpp)
target_link_libraries(turntable PRIVATE gauss::runtime Boost::headers)
gauss_add_model(TARGET turntable MODEL sphere_turntable.yaml)
