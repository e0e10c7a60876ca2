// SPDX-License-Identifier: Apache-2.0
#include "topology/instance_scope.h"

namespace hexweave {

namespace {

bool is_within(const InstanceScope* scope, const InstanceScope* outer) {
    while (scope != nullptr && scope != outer) scope = scope->outer.get();
    return scope == outer;
}

}  // namespace

Affine map_between(const ScopePointer& from, const ScopePointer& to) {
    Affine whole;
    for (const InstanceScope* scope = from.get(); scope != nullptr && !is_within(to.get(), scope);
         scope = scope->outer.get()) {
        whole = compose(whole, scope->map);
    }
    return whole;
}

double total_scale(const ScopePointer& scope) {
    double scale = 1;
    for (const InstanceScope* s = scope.get(); s != nullptr; s = s->outer.get()) scale *= s->scale;
    return scale;
}

bool is_mirrored(const ScopePointer& scope) {
    const Affine whole = map_between(scope, nullptr);
    return triple(whole.rows[0], whole.rows[1], whole.rows[2]) < 0;
}

std::string qualified(const std::string& name, const ScopePointer& scope) {
    if (!scope || scope->prefix.empty() || name.empty()) return name;
    std::string whole = scope->prefix;
    for (const char c : name) {
        whole += c;
        if (c == '-') whole += scope->prefix;
    }
    return whole;
}

std::string local_name(const std::string& name, const ScopePointer& scope) {
    const bool has_prefix = scope && name.compare(0, scope->prefix.size(), scope->prefix) == 0;
    return has_prefix ? name.substr(scope->prefix.size()) : name;
}

}  // namespace hexweave
