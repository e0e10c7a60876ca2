// SPDX-License-Identifier: Apache-2.0
// What a text that is used several times means where it is used: an instance of a component has its
// own names, parameters and place in space; a repeated entry has the value of its index.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "geometry/transform.h"
#include "topology/expressions.h"

namespace hexweave {

struct InstanceScope {
    std::string prefix;                    ///< of all names: "flap.", "flap.slot."
    std::shared_ptr<InstanceScope> outer;  ///< where the instance or the entry stands; null: case
    bool repeats = false;                  ///< an index of a repeated entry, no instance
    bool own_families = false;             ///< its boundaries are families of their own
    ParameterScope parameters{};
    Affine map{};      ///< from the component's coordinates into the outer ones
    double scale = 1;  ///< of lengths, by the map
};

using ScopePointer = std::shared_ptr<InstanceScope>;

/// From the coordinates of a scope into those of another, or of the case (null), that it stands
/// within; whatever else stands there leaves coordinates alone.
Affine map_between(const ScopePointer& from, const ScopePointer& to);
/// By how much lengths of a scope are larger in the case.
double total_scale(const ScopePointer& scope);
/// Whether what is right-handed in a scope is left-handed in the case.
bool is_mirrored(const ScopePointer& scope);
/// "flap.wake", "flap.a-flap.b": names of a scope as the whole case knows them.
std::string qualified(const std::string& name, const ScopePointer& scope);
/// The name that was written of one that a scope defines.
std::string local_name(const std::string& name, const ScopePointer& scope);

}  // namespace hexweave
