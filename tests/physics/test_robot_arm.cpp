// A tree of bodies with full inertia matrices, against Newton's and Euler's equations of its bodies (tools/oracles).
#include "robot_arm.hpp"
#include "states.hpp"

using reference::Json;
using reference::number;

namespace arm = gauss::robot_arm;

GAUSS_MODEL(Arm, arm);

namespace {

void check_joints(const Json& sample, const arm::State<double>& state, const arm::Inputs<double>& inputs,
                  const arm::Prepared<double>& prepared, double tolerance) {
  const Json& expected = sample["forces"];
  const double margin = tolerance * physics::size_of_forces(expected);
  arm::JointReactions<double> joints;
  REQUIRE(joint_reactions(0.0, state, inputs, prepared, joints) == gauss::Status::ok);
  physics::check_joint(expected, "base", joints.base, margin);
  physics::check_joint(expected, "shoulder", joints.shoulder, margin);
  physics::check_joint(expected, "elbow", joints.elbow, margin);
  physics::check_joint(expected, "roll", joints.roll, margin);
  physics::check_joint(expected, "wrist", joints.wrist, margin);
  physics::check_joint(expected, "flange", joints.flange, margin);
  physics::check_joint(expected, "left", joints.left, margin);
  physics::check_joint(expected, "right", joints.right, margin);
}

arm::Inputs<double> inputs_of(const Json& drives) {
  arm::Inputs<double> inputs;
  inputs.tau1 = number(drives["tau1"]);
  inputs.tau2 = number(drives["tau2"]);
  inputs.tau3 = number(drives["tau3"]);
  inputs.tau4 = number(drives["tau4"]);
  inputs.tau5 = number(drives["tau5"]);
  inputs.tau6 = number(drives["tau6"]);
  inputs.grip1 = number(drives["grip1"]);
  inputs.grip2 = number(drives["grip2"]);
  return inputs;
}

}  // namespace

TEST_CASE("an arm with a gripper accelerates as Newton and Euler say, with force and moment in all eight joints") {
  const auto file = reference::read("robot_arm");
  const auto prepared = prepare(arm::Parameters<double>{});
  REQUIRE(file["expected"]["states"].size() >= 4);
  for (const auto& sample : file["expected"]["states"]) {
    const auto inputs = inputs_of(sample["inputs"]);
    physics::check_accelerations<Arm>(sample, inputs, prepared, 1e-12);
    check_joints(sample, physics::state_of<Arm>(sample["state"]), inputs, prepared, 1e-12);
  }
}

TEST_CASE("an arm under constant torques moves as Newton and Euler say") {
  const auto file = reference::read("robot_arm");
  const auto prepared = prepare(arm::Parameters<double>{});
  const arm::Inputs<double> inputs;
  arm::State<double> start;
  REQUIRE(initial_state(prepared, start) == gauss::Status::ok);
  physics::follow<Arm>(file["expected"]["motion"], prepared, inputs, start,
                       [&](const auto& sample, double, const auto& state) {
                         physics::check_state<Arm>(sample["state"], state, 1e-10);
                         check_joints(sample, state, inputs, prepared, 1e-10);
                       });
}
