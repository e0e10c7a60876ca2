// SPDX-License-Identifier: Apache-2.0
// Which names mean the same entity, and the case with one name for each.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "topology/case.h"

namespace hexweave {

struct JoinedEdge {
    std::string name;
    bool reversed = false;
};

class JoinedNames {
public:
    void join_vertex(const std::string& inside, const std::string& outside);
    /// Precondition: both stay so far.
    void join_edge(const std::string& inside, const JoinedEdge& outside);
    void join_face(const std::string& inside, const std::string& outside);

    /// The name that stays of all that are joined.
    std::string vertex(const std::string& name) const;
    JoinedEdge edge(const std::string& name) const;
    std::string face(const std::string& name) const;

private:
    std::map<std::string, std::string> vertices_;
    std::map<std::string, JoinedEdge> edges_;
    std::map<std::string, std::string> faces_;
};

/// Parts of ports with what has become of them in the end, each once, without those that stay.
std::vector<JoinedPart> settled(const JoinedNames& joined, const std::vector<JoinedPart>& parts);

/// Takes what was joined to something else out of a case, and names the other in its place. What
/// it alone used does not count as unused.
void rename_joined(Case& c, const JoinedNames& joined);

/// The law of an edge run through backwards.
SpacingEntry reversed_law(const SpacingEntry& law);

}  // namespace hexweave
