// MuJoCo, loaded while the program runs: the few functions that a body needs.
#pragma once

#include <mujoco/mujoco.h>

#include <string>

#include "core/error.hpp"

namespace deixis::physics {

struct MujocoLibrary {
    decltype(&mj_version) version = nullptr;
    decltype(&mj_loadXML) load_xml = nullptr;
    decltype(&mj_deleteModel) delete_model = nullptr;
    decltype(&mj_makeData) make_data = nullptr;
    decltype(&mj_copyData) copy_data = nullptr;
    decltype(&mj_resetData) reset_data = nullptr;
    decltype(&mj_deleteData) delete_data = nullptr;
    decltype(&mj_step) step = nullptr;
    decltype(&mj_forward) forward = nullptr;
    decltype(&mj_kinematics) kinematics = nullptr;
    decltype(&mj_id2name) id_to_name = nullptr;
};

/// The library is loaded once, and stays. `name`: as Body::make has it. Its errors become exceptions (they
/// would end the program), its warnings nothing (they would write a file in the current folder).
[[nodiscard]] Result<const MujocoLibrary*> loadMujoco(const std::string& name);

}  // namespace deixis::physics
