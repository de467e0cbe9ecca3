#pragma once
// Every test includes this and nothing of Catch2 directly: version 3 has other headers.

#include <catch2/catch.hpp>
