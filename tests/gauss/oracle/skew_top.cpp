#include "gauss/oracle/skew_top.hpp"

namespace gaussgen::oracle::skew_top {

std::string orientations(const std::string& frame) {
  return R"(
orientations:
  attitude:
    quaternion: [e0, e1, e2, e3]
    angular_velocity: [wx, wy, wz]
    initial: [1, 0, 0, 0]
    frame: )" +
         frame + "\n";
}

Body body(const Values& v) {
  const Body straight = triaxial_body(v.at("m"), {v.at("A"), v.at("B"), v.at("C")});
  return turned(straight, {{{Real("0.6"), Real("0.8"), 0}, {Real("-0.8"), Real("0.6"), 0}, {0, 0, 1}}});
}

Quaternion attitude(const Values& v) { return {v.at("e0"), v.at("e1"), v.at("e2"), v.at("e3")}; }

}  // namespace gaussgen::oracle::skew_top
