// What the loader and an API layer say to each other when an instance is made. Older headers of OpenXR
// (Debian 12's) lack these structures; they are the loader's binary interface, version 1
// (openxr_loader_negotiation.h).
#pragma once

#include <openxr/openxr.h>

#include <cstddef>
#include <cstdint>

namespace deixis::conditions {

constexpr std::uint32_t interface_version = 1;
constexpr std::size_t settings_path_size = 512;

enum class LoaderStructure : std::int32_t {
    loader_info = 1,
    api_layer_request = 2,
    runtime_request = 3,
    api_layer_create_info = 4,
    api_layer_next_info = 5
};

struct LayerCreateInfo;
using CreateLayerInstance = XrResult(XRAPI_PTR*)(const XrInstanceCreateInfo* info,
                                                 const LayerCreateInfo* layer_info, XrInstance* instance);

/// The next layer in the chain, or the loader's end of it.
struct LayerNextInfo {
    LoaderStructure type;
    std::uint32_t version;
    std::size_t size;
    char layer_name[XR_MAX_API_LAYER_NAME_SIZE];
    PFN_xrGetInstanceProcAddr next_get_instance_proc_addr;
    CreateLayerInstance next_create_layer_instance;
    LayerNextInfo* next;
};

struct LayerCreateInfo {
    LoaderStructure type;
    std::uint32_t version;
    std::size_t size;
    void* loader_instance;
    char settings_file[settings_path_size];
    LayerNextInfo* next_info;
};

struct LoaderInfo {
    LoaderStructure type;
    std::uint32_t version;
    std::size_t size;
    std::uint32_t min_interface_version;
    std::uint32_t max_interface_version;
    XrVersion min_api_version;
    XrVersion max_api_version;
};

struct LayerRequest {
    LoaderStructure type;
    std::uint32_t version;
    std::size_t size;
    std::uint32_t layer_interface_version;
    XrVersion layer_api_version;
    PFN_xrGetInstanceProcAddr get_instance_proc_addr;
    CreateLayerInstance create_layer_instance;
};

}  // namespace deixis::conditions
