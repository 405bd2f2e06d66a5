#pragma once

namespace tautline::mujoco {

/// Takes over MuJoCo's errors and warnings, for the process: an error would end it, and both would
/// write MUJOCO_LOG.TXT into the user's folder. An error is a std::runtime_error from now on.
void use_library();

/// Throws std::runtime_error with the warning that MuJoCo gave this thread since the last call, if
/// it gave one: it warns where it has put a diverged body back to its start.
void throw_warning();

}  // namespace tautline::mujoco
