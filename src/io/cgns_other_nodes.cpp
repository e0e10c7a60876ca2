// SPDX-License-Identifier: Apache-2.0
// What a CGNS file holds that the reader does not read: found by walking the tree of nodes itself,
// for libcgns keeps silent about labels that it does not know.
#include <cgns_io.h>

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "io/cgns_source.h"

namespace hexweave {
namespace {

struct TreeNode {
    std::string name;
    std::string label;
    double id = 0;
};

class TreeWalk {
public:
    TreeWalk(const CgnsSource& source, const GridOutline& outline) : source_(source) {
        source.check(cg_get_cgio(source.file(), &tree_));
        for (const ZoneOutline& zone : outline.zones) read_.insert(zone.name);
        for (const BoundaryPatch& patch : outline.patches) {
            const ZoneOutline& zone = outline.zones[static_cast<std::size_t>(patch.zone)];
            read_.insert(zone.name + "/" + patch.name);
        }
    }

    std::vector<OtherNodes> find() {
        TreeNode root;
        source_.check(cg_root_id(source_.file(), &root.id));
        look_below(root, "");
        return std::move(found_);
    }

private:
    void check(int answer) const {
        if (answer != CG_OK) source_.damaged();
    }

    std::vector<TreeNode> children(const TreeNode& parent) const {
        int count = 0;
        check(cgio_number_children(tree_, parent.id, &count));
        std::vector<double> ids(static_cast<std::size_t>(count));
        int got = 0;
        if (count > 0) check(cgio_children_ids(tree_, parent.id, 1, count, &got, ids.data()));
        ids.resize(static_cast<std::size_t>(got));
        std::vector<TreeNode> nodes;
        for (const double id : ids) {
            CgnsName name{};
            CgnsName label{};
            check(cgio_get_name(tree_, id, name.data()));
            check(cgio_get_label(tree_, id, label.data()));
            nodes.push_back({name.data(), label.data(), id});
        }
        return nodes;
    }

    void note(const TreeNode& node, const std::string& path) {
        const auto same = std::find_if(found_.begin(), found_.end(), [&](const OtherNodes& kind) {
            return kind.kind == node.label;
        });
        if (same != found_.end()) {
            ++same->count;
        } else {
            found_.push_back({node.label, path, 1});
        }
    }

    /// Whether the reader has left out this node, of a kind that it knows.
    bool is_left_out(const TreeNode& node, const std::string& path) {
        if (node.label == "CGNSBase_t") {
            if (base_.empty()) base_ = path + "/";
            return path + "/" != base_;
        }
        if (node.label != "Zone_t" && node.label != "BC_t") return false;
        const std::string below = path.substr(base_.size());
        const std::string zone = below.substr(0, below.find('/'));
        return read_.count(node.label == "Zone_t" ? zone : zone + "/" + node.name) == 0;
    }

    void look_below(const TreeNode& parent, const std::string& parent_path);

    const CgnsSource& source_;
    int tree_ = 0;
    std::string base_;            ///< the path of the first base, with a slash behind
    std::set<std::string> read_;  ///< "ZONE" and "ZONE/CONDITION" for all that the outline has
    std::vector<OtherNodes> found_;
};

/// What a node of ours may hold. An empty name stands for any; `inside`: its children are looked at
/// as well.
struct KnownNode {
    std::string_view parent;
    std::string_view label;
    std::string_view name;
    bool inside;
};

constexpr KnownNode known_nodes[] = {
    {"", "CGNSLibraryVersion_t", "", false},
    {"", "CGNSBase_t", "", true},
    {"CGNSBase_t", "Zone_t", "", true},
    {"CGNSBase_t", "Family_t", "", true},
    {"CGNSBase_t", "DataClass_t", "", false},
    {"CGNSBase_t", "DimensionalUnits_t", "", false},
    {"CGNSBase_t", "Descriptor_t", title_descriptor, false},
    {"CGNSBase_t", "Descriptor_t", provenance_descriptor, false},
    {"Family_t", "FamilyBC_t", "", true},
    {"Family_t", "UserDefinedData_t", "", true},
    {"Zone_t", "ZoneType_t", "", false},
    {"Zone_t", "DataClass_t", "", false},
    {"Zone_t", "DimensionalUnits_t", "", false},
    {"Zone_t", "GridCoordinates_t", "GridCoordinates", true},
    {"Zone_t", "ZoneBC_t", "", true},
    {"Zone_t", "ZoneGridConnectivity_t", "", true},
    {"GridCoordinates_t", "DataClass_t", "", false},
    {"GridCoordinates_t", "DimensionalUnits_t", "", false},
    {"GridCoordinates_t", "DataArray_t", "CoordinateX", true},
    {"GridCoordinates_t", "DataArray_t", "CoordinateY", true},
    {"GridCoordinates_t", "DataArray_t", "CoordinateZ", true},
    {"DataArray_t", "DataClass_t", "", false},
    {"DataArray_t", "DimensionalUnits_t", "", false},
    {"DataArray_t", "DimensionalExponents_t", "", false},
    {"ZoneBC_t", "BC_t", "", true},
    {"BC_t", "IndexRange_t", "", false},
    {"BC_t", "IndexArray_t", "PointList", false},
    {"BC_t", "IndexArray_t", "ElementList", false},
    {"BC_t", "FamilyName_t", "", false},
    {"BC_t", "GridLocation_t", "", false},
    {"ZoneGridConnectivity_t", "GridConnectivity1to1_t", "", true},
    {"GridConnectivity1to1_t", "\"int[IndexDimension]\"", "", false},
    {"GridConnectivity1to1_t", "IndexRange_t", "", false},
    {"GridConnectivity1to1_t", "GridConnectivityProperty_t", "", true},
    {"GridConnectivityProperty_t", "Periodic_t", "", true},
    {"Periodic_t", "DataClass_t", "", false},
    {"Periodic_t", "DimensionalUnits_t", "", false},
    {"Periodic_t", "DataArray_t", "RotationCenter", true},
    {"Periodic_t", "DataArray_t", "RotationAngle", true},
    {"Periodic_t", "DataArray_t", "Translation", true},
};

const KnownNode* find_known(std::string_view parent, const TreeNode& node) {
    for (const KnownNode& known : known_nodes) {
        if (known.parent == parent && known.label == node.label &&
            (known.name.empty() || known.name == node.name)) {
            return &known;
        }
    }
    return nullptr;
}

void TreeWalk::look_below(const TreeNode& parent, const std::string& parent_path) {
    for (const TreeNode& node : children(parent)) {
        const std::string path = parent_path + "/" + node.name;
        const KnownNode* known = find_known(parent.label, node);
        if (known == nullptr || is_left_out(node, path)) {
            note(node, path);
        } else if (known->inside) {
            look_below(node, path);
        }
        check(cgio_release_id(tree_, node.id));
    }
}

}  // namespace

std::vector<OtherNodes> find_other_nodes(const CgnsSource& source, const GridOutline& outline) {
    return TreeWalk(source, outline).find();
}

}  // namespace hexweave
