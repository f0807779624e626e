#include "assets/gltf/gltf_document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <set>
#include <tuple>

#include "gltf_container.hpp"
#include "gltf_reading.hpp"

namespace deixis::assets::gltf {

namespace {

constexpr std::size_t max_nodes = 65536;
constexpr std::size_t max_remarks = 12;

/// Whether a required extension leaves alone what is read here, or is read.
bool isKnown(std::string_view name, Content content) {
    // These concern a figure's looks alone, and not so much that it could not be shown.
    constexpr std::array<std::string_view, 17> both{
        "KHR_materials_unlit",
        "KHR_texture_transform",
        "KHR_mesh_quantization",
        "KHR_materials_emissive_strength",
        "KHR_materials_ior",
        "KHR_materials_specular",
        "KHR_materials_sheen",
        "KHR_materials_clearcoat",
        "KHR_lights_punctual",
        "VRM",
        "VRMC_vrm",
        "VRMC_materials_mtoon",
        "VRMC_materials_hdr_emissiveMultiplier",
        "VRMC_springBone",
        "VRMC_springBone_extended_collider",
        "VRMC_springBone_limit",
        "VRMC_node_constraint",
    };
    if (std::find(both.begin(), both.end(), name) != both.end()) return true;
    if (content == Content::figure) return false;
    for (const std::string_view prefix : {"KHR_materials_", "KHR_texture_", "EXT_texture_", "VRMC_"})
        if (name.starts_with(prefix)) return true;
    return name == "KHR_draco_mesh_compression" || name == "EXT_mesh_gpu_instancing" ||
           name == "EXT_lights_image_based" || name == "KHR_xmp_json_ld";
}

bool isMatrix(const std::string& type) {
    return type.substr(0, 3) == "MAT";
}

class DocumentReader {
  public:
    DocumentReader(const Cursor& root, Content content, Document& document)
        : root_(root), content_(content), doc_(document) {}

    void read() {
        readAsset();
        readList("buffers", &DocumentReader::readBuffer);
        readList("bufferViews", &DocumentReader::readView);
        readList("accessors", &DocumentReader::readAccessor);
        const std::size_t nodes = root_.count("nodes");
        if (nodes > max_nodes)
            reject(doc_.file, fmt::format("has {} nodes, expected at most {}", nodes, max_nodes),
                   "Export the armature alone");
        doc_.nodes.resize(nodes);
        readList("nodes", &DocumentReader::readNode);
        numberNodes();
        readList("skins", &DocumentReader::readSkin);
        if (content_ == Content::clip)
            readList("animations", &DocumentReader::readAnimation);
        else
            readFigure(root_, doc_);
        doc_.humanoid = readHumanoid(root_, doc_.nodes.size(), doc_.remarks);
        if (violations_ > max_remarks)
            doc_.remarks.push_back(
                fmt::format("and {} more places violate the specification", violations_ - max_remarks));
    }

  private:
    /// Tells a breach of the specification that does no harm here.
    void tell(const Cursor& where, std::string_view what) {
        if (++violations_ <= max_remarks)
            doc_.remarks.push_back(fmt::format("{} {} (violates the specification)", where.path(), what));
    }

    /// Each element of a list; an empty list is told.
    void readList(const char* name, void (DocumentReader::*read_one)(const Cursor&)) {
        if (!root_.has(name)) return;
        tellEmpty(root_.at(name));
        for (const Cursor& one : root_.elements(name)) (this->*read_one)(one);
    }

    void tellEmpty(const Cursor& list) {
        if (list.size() == 0) tell(list, "is empty");
    }

    void readAsset() {
        const std::string version = root_.at("asset").at("version").text();
        if (version.substr(0, 2) != "2.")
            reject(doc_.file, fmt::format("has glTF version {}, expected 2.0", version),
                   "Export it as glTF 2.0");
        for (const Cursor& one : root_.elements("extensionsRequired"))
            if (const std::string& name = one.text(); !isKnown(name, content_))
                reject(doc_.file, fmt::format("requires the extension {}, which is not known", name),
                       content_ == Content::clip
                           ? "Export it without that extension"
                           : "Export without compression, and with PNG or JPEG textures");
    }

    void readBuffer(const Cursor& in) {
        doc_.buffers.push_back({readOutside(in, doc_.file), in.at("byteLength").whole()});
    }

    void readView(const Cursor& in) {
        BufferView view;
        view.buffer = in.at("buffer").index(doc_.buffers.size(), "buffer");
        view.offset = in.whole("byteOffset", 0);
        view.length = in.at("byteLength").whole();
        view.stride = in.whole("byteStride", 0);
        if (view.stride > 252)
            tell(in, fmt::format("has the stride {}, at most 252 is allowed", view.stride));
        const std::size_t size = doc_.buffers[static_cast<std::size_t>(view.buffer)].length;
        if (view.offset > size || view.length > size - view.offset) tell(in, "leaves its buffer");
        doc_.views.push_back(view);
    }

    void readAccessor(const Cursor& in) {
        Accessor accessor;
        accessor.view = in.index("bufferView", doc_.views.size(), "buffer view");
        accessor.offset = in.whole("byteOffset", 0);
        accessor.count = in.at("count").whole();
        const std::size_t component = in.at("componentType").whole();
        accessor.component_type = component < 100'000 ? static_cast<int>(component) : 0;
        accessor.type = in.at("type").text();
        accessor.normalised = in.has("normalized") && in.at("normalized").flag();
        accessor.has_bounds = in.has("min") && in.has("max");
        if (accessor.count == 0) tell(in, "has no elements");
        if (accessor.view < 0 && in.has("byteOffset")) tell(in, "has a byteOffset and no buffer view");
        if (accessor.normalised && (component == 5126 || component == 5125))
            tell(in, "is normalised, which only small integers can be");
        checkAlignment(in, accessor);
        if (in.has("sparse")) accessor.sparse = readSparse(in.at("sparse"), accessor);
        doc_.accessors.push_back(std::move(accessor));
    }

    void checkAlignment(const Cursor& in, const Accessor& accessor) {
        const std::size_t size = componentSize(accessor.component_type);
        if (size == 0 || accessor.view < 0) return;
        const BufferView& view = doc_.views[static_cast<std::size_t>(accessor.view)];
        const std::size_t grid = isMatrix(accessor.type) ? 4 : size;
        if (accessor.offset % grid != 0 || (view.offset % grid + accessor.offset % grid) % grid != 0)
            tell(in, "is not aligned");
        if (view.stride != 0 && view.stride < elementSize(accessor))
            tell(in, "has elements longer than their stride");
    }

    Sparse readSparse(const Cursor& in, const Accessor& accessor) {
        Sparse sparse;
        sparse.count = in.at("count").whole();
        if (sparse.count > accessor.count) tell(in, "replaces more elements than there are");
        const Cursor indices = in.at("indices");
        const Cursor values = in.at("values");
        sparse.index_view = indices.at("bufferView").index(doc_.views.size(), "buffer view");
        sparse.index_offset = indices.whole("byteOffset", 0);
        sparse.index_type =
            static_cast<int>(std::min<std::size_t>(indices.at("componentType").whole(), 9999));
        sparse.value_view = values.at("bufferView").index(doc_.views.size(), "buffer view");
        sparse.value_offset = values.whole("byteOffset", 0);
        for (const int view : {sparse.index_view, sparse.value_view})
            if (doc_.views[static_cast<std::size_t>(view)].stride != 0) tell(in, "has a stride");
        return sparse;
    }

    static Vec3 readVector(const Cursor& in) {
        const auto v = readNumbers<3>(in);
        return {v[0], v[1], v[2]};
    }

    void readNode(const Cursor& in) {
        const auto index = next_node_++;
        Node& node = doc_.nodes[index];
        node.name = in.text("name", "");
        if (in.has("translation")) node.translation = readVector(in.at("translation"));
        if (in.has("scale")) node.scale = readVector(in.at("scale"));
        if (in.has("rotation")) {
            const auto q = readNumbers<4>(in.at("rotation"));
            node.rotation = unitRotation(in.at("rotation"), Quat(q[3], q[0], q[1], q[2]));
        }
        has_matrix_.push_back(in.has("matrix"));
        if (in.has("matrix")) {
            readMatrix(in.at("matrix"), node);
            if (in.has("translation") || in.has("rotation") || in.has("scale"))
                tell(in, "has both a matrix and its parts; the matrix is used");
        }
        if (in.has("children")) readChildren(in.at("children"), static_cast<int>(index), node);
        static_cast<void>(in.index("camera", root_.count("cameras"), "camera"));
        node.mesh = in.index("mesh", root_.count("meshes"), "mesh");
        node.skin = in.index("skin", root_.count("skins"), "skin");
        if (node.skin >= 0 && node.mesh < 0) tell(in, "has a skin and no mesh");
        if (in.has("weights") && node.mesh < 0) tell(in, "has weights and no mesh");
    }

    Quat unitRotation(const Cursor& in, const Quat& found) {
        const double length = glm::length(found);
        if (!(length > 1e-3 && length < 1e3))
            in.reject(fmt::format("is a quaternion of length {}, expected 1", length));
        if (std::abs(length - 1.0) > 0.01) tell(in, fmt::format("is a quaternion of length {:.4g}", length));
        return content_ == Content::figure ? found : found / length;
    }

    void readMatrix(const Cursor& in, Node& node) {
        const auto m = readNumbers<16>(in);
        if (content_ == Content::figure) {
            node.matrix.emplace();
            for (int i = 0; i < 16; ++i) (*node.matrix)[i / 4][i % 4] = m[static_cast<std::size_t>(i)];
            return;
        }
        glm::dmat3 linear(m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]);
        for (int axis = 0; axis < 3; ++axis) {
            node.scale[axis] = glm::length(linear[axis]);
            if (!(node.scale[axis] > 0.0)) in.reject("flattens space, which no rotation and scale do");
        }
        if (glm::determinant(linear) < 0.0) node.scale.x = -node.scale.x;
        for (int axis = 0; axis < 3; ++axis) linear[axis] /= node.scale[axis];
        for (int a = 0; a < 3; ++a)
            if (!(std::abs(glm::dot(linear[a], linear[(a + 1) % 3])) < 1e-3))
                in.reject("shears, which no translation, rotation and scale do");
        if (m[3] != 0.0 || m[7] != 0.0 || m[11] != 0.0 || m[15] != 1.0)
            in.reject("has another last row than 0, 0, 0, 1");
        node.translation = Vec3(m[12], m[13], m[14]);
        if (linear != glm::dmat3(1.0)) node.rotation = glm::normalize(glm::quat_cast(linear));
    }

    void readChildren(const Cursor& in, int index, Node& node) {
        tellEmpty(in);
        for (std::size_t i = 0; i < in.size(); ++i) {
            const int child = in.at(i).index(doc_.nodes.size(), "node");
            int& parent = doc_.nodes[static_cast<std::size_t>(child)].parent;
            if (parent >= 0)
                in.at(i).reject(
                    fmt::format("node {} is already a child of node {}; expected a tree", child, parent));
            parent = index;
            node.children.push_back(child);
        }
    }

    /// Numbers the nodes depth first from the roots; what that does not reach stands in a ring.
    void numberNodes() {
        const std::size_t size = doc_.nodes.size();
        root_of_.assign(size, -1);
        first_.assign(size, 0);
        last_.assign(size, 0);
        std::size_t next = 0;
        for (std::size_t root = 0; root < size; ++root) {
            if (doc_.nodes[root].parent >= 0) continue;
            std::vector<std::pair<std::size_t, std::size_t>> stack{{root, 0}};  // node, next of its children
            first_[root] = next++;
            while (!stack.empty()) {
                auto& [node, child] = stack.back();
                root_of_[node] = static_cast<int>(root);
                if (child == doc_.nodes[node].children.size()) {
                    last_[node] = next;
                    stack.pop_back();
                    continue;
                }
                const auto below = static_cast<std::size_t>(doc_.nodes[node].children[child++]);
                first_[below] = next++;
                stack.emplace_back(below, 0);
            }
        }
        for (std::size_t node = 0; node < size; ++node)
            if (root_of_[node] < 0)
                reject(
                    doc_.file,
                    fmt::format("node {} is its own ancestor or below such a node; expected a tree", node));
    }

    [[nodiscard]] bool isAbove(int top, int node) const {
        const std::size_t at = first_[static_cast<std::size_t>(node)];
        return first_[static_cast<std::size_t>(top)] <= at && at < last_[static_cast<std::size_t>(top)];
    }

    void readSkin(const Cursor& in) {
        const Cursor list = in.at("joints");
        tellEmpty(list);
        Skin skin;
        std::set<int> seen, roots;
        for (const Cursor& one : in.elements("joints")) {
            const int joint = one.index(doc_.nodes.size(), "node");
            if (!seen.insert(joint).second) tell(one, "is a joint twice");
            skin.joints.push_back(joint);
            roots.insert(root_of_[static_cast<std::size_t>(joint)]);
        }
        if (roots.size() > 1) tell(list, "have no common root");
        if (const int top = in.index("skeleton", doc_.nodes.size(), "node"); top >= 0)
            if (!std::all_of(skin.joints.begin(), skin.joints.end(),
                             [&](int joint) { return isAbove(top, joint); }))
                tell(in, "names a skeleton that is not above its joints");
        skin.inverse_bind = in.index("inverseBindMatrices", doc_.accessors.size(), "accessor");
        if (skin.inverse_bind >= 0) {
            const Accessor& accessor = doc_.accessors[static_cast<std::size_t>(skin.inverse_bind)];
            if (accessor.type != "MAT4" || accessor.component_type != 5126 ||
                accessor.count < skin.joints.size())
                tell(in, "has inverse bind matrices that are not one float MAT4 for each joint");
            if (accessor.view >= 0 && doc_.views[static_cast<std::size_t>(accessor.view)].stride != 0)
                tell(in, "has inverse bind matrices with a stride");
        }
        doc_.skins.push_back(std::move(skin));
    }

    void readAnimation(const Cursor& in) {
        Animation animation;
        animation.name = in.text("name", "");
        const Cursor samplers = in.at("samplers");
        const Cursor channels = in.at("channels");
        tellEmpty(samplers);
        tellEmpty(channels);
        for (std::size_t i = 0; i < samplers.size(); ++i)
            animation.samplers.push_back(readSampler(samplers.at(i)));
        std::set<std::pair<int, Path>> targets;
        for (std::size_t i = 0; i < channels.size(); ++i) {
            const auto channel = readChannel(channels.at(i), animation);
            if (!channel) {
                animation.has_others = true;
                continue;
            }
            if (!targets.emplace(channel->node, channel->path).second) {
                tell(channels.at(i), "moves what another channel moves; the first is used");
                continue;
            }
            if (has_matrix_[static_cast<std::size_t>(channel->node)])
                tell(channels.at(i), "moves a node that has a matrix");
            animation.channels.push_back(*channel);
        }
        doc_.animations.push_back(std::move(animation));
    }

    [[nodiscard]] Sampler readSampler(const Cursor& in) const {
        Sampler sampler;
        sampler.input = in.at("input").index(doc_.accessors.size(), "accessor");
        sampler.output = in.at("output").index(doc_.accessors.size(), "accessor");
        const std::string name = in.text("interpolation", "LINEAR");
        if (name == "STEP")
            sampler.interpolation = Interpolation::step;
        else if (name == "CUBICSPLINE")
            sampler.interpolation = Interpolation::cubic_spline;
        else if (name != "LINEAR")
            in.at("interpolation")
                .reject(fmt::format("found \"{}\", expected STEP, LINEAR or CUBICSPLINE", name));
        return sampler;
    }

    [[nodiscard]] std::optional<Channel> readChannel(const Cursor& in, const Animation& animation) const {
        Channel channel;
        channel.sampler = in.at("sampler").index(animation.samplers.size(), "sampler");
        const Cursor target = in.at("target");
        const std::string& path = target.at("path").text();
        channel.node = target.index("node", doc_.nodes.size(), "node");
        if (path == "translation")
            channel.path = Path::translation;
        else if (path == "rotation")
            channel.path = Path::rotation;
        else if (path == "scale")
            channel.path = Path::scale;
        else
            return std::nullopt;
        if (channel.node < 0) return std::nullopt;
        return channel;
    }

    const Cursor& root_;
    Content content_;
    Document& doc_;
    std::size_t next_node_ = 0;
    std::vector<bool> has_matrix_;
    // Of each node: its root, and its place and the end of its descendants in depth first order.
    std::vector<int> root_of_;
    std::vector<std::size_t> first_, last_;
    std::size_t violations_ = 0;
};

}  // namespace

std::size_t componentSize(int component_type) {
    switch (component_type) {
        case 5120:  // BYTE
        case 5121:  // UNSIGNED_BYTE
            return 1;
        case 5122:  // SHORT
        case 5123:  // UNSIGNED_SHORT
            return 2;
        case 5125:  // UNSIGNED_INT
        case 5126:  // FLOAT
            return 4;
        default:
            return 0;
    }
}

std::size_t elementWidth(const std::string& type) {
    constexpr std::array<std::pair<std::string_view, std::size_t>, 7> widths{
        {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT2", 4}, {"MAT3", 9}, {"MAT4", 16}}};
    for (const auto& [name, width] : widths)
        if (name == type) return width;
    return 0;
}

std::size_t elementSize(const Accessor& accessor) {
    const std::size_t component = componentSize(accessor.component_type);
    const std::size_t width = elementWidth(accessor.type);
    if (!isMatrix(accessor.type)) return component * width;
    // Columns begin on multiples of 4 bytes (section 3.6.2.4).
    const std::size_t columns = width == 4 ? 2 : width == 9 ? 3 : 4;
    return columns * ((component * columns + 3) / 4 * 4);
}

Outside readOutside(const Cursor& in, const std::string& file) {
    if (!in.has("uri")) return {};
    const std::string& uri = in.at("uri").text();
    if (uri.starts_with("data:")) return {uri, {}};
    return {{}, neighbourPath(uri, file + ": " + in.at("uri").path())};
}

Document readDocument(std::string_view bytes, const std::string& file, Content content) {
    const Chunks chunks = splitChunks(bytes, file);
    Document document;
    document.file = file;
    document.bin = chunks.bin;
    document.has_bin = chunks.has_bin;
    const nlohmann::json json = parseJson(chunks.json, file);
    const Cursor root(json, file);
    DocumentReader(root, content, document).read();
    return document;
}

}  // namespace deixis::assets::gltf
