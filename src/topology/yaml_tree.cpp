// SPDX-License-Identifier: Apache-2.0
#include "topology/yaml_tree.h"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/mark.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <utility>

#include "topology/source_text.h"
#include "topology/text_limit.h"
#include "topology/yaml_end.h"
#include "topology/yaml_faults.h"
#include "topology/yaml_slips.h"

namespace hexweave {

namespace {

constexpr std::size_t maximum_depth = 100;
constexpr std::size_t maximum_copied = 200'000;   ///< nodes for anchors and their aliases
constexpr std::size_t maximum_nodes = 1'000'000;  ///< of a file

/// Ends the parsing from inside an event; the diagnostic is already told.
struct ParsingEnded {};

/// What a copy of a node takes: its nodes, where a long text counts as many.
std::size_t size_of_copy(const YamlNode& node) {
    constexpr std::size_t bytes_of_node = 100;
    std::size_t size = 1 + (node.text.size() + node.key.size()) / bytes_of_node;
    for (const YamlNode& child : node.children) size += size_of_copy(child);
    return size;
}

/// The offset behind anchors (`&name`) that stand before a node.
std::size_t skip_anchor(std::string_view text, std::size_t offset) {
    if (offset >= text.size() || text[offset] != '&') return offset;
    const std::size_t end = text.find_first_of(" \t\r\n", offset);
    const std::size_t next = text.find_first_not_of(" \t\r\n", end);
    return next == std::string_view::npos ? offset : next;
}

/// The offset behind the closing quote of a text that opens at `offset`; npos where it is open.
std::size_t end_of_quoted(std::string_view text, std::size_t offset) {
    const char quote = text[offset];
    for (std::size_t i = offset + 1; i < text.size(); ++i) {
        if (quote == '"' && text[i] == '\\') {
            ++i;
        } else if (text[i] == quote) {
            if (quote == '"' || i + 1 >= text.size() || text[i + 1] != '\'') return i + 1;
            ++i;
        }
    }
    return std::string_view::npos;
}

class TreeBuilder : public YAML::EventHandler {
public:
    TreeBuilder(const SourcePlaces& places, Diagnostics& diagnostics)
        : places_(places), diagnostics_(diagnostics) {}

    YamlNode take_root() { return std::move(root_); }

    /// The bracket that is still open, for a syntax error.
    std::optional<Note> open_bracket() const {
        const auto flow = std::find_if(open_.rbegin(), open_.rend(),
                                       [](const OpenNode& open) { return open.flow; });
        if (flow == open_.rend()) return std::nullopt;
        const char bracket = flow->node.is_mapping() ? '{' : '[';
        return Note{flow->node.place, fmt::format("inside the '{}' that opens here", bracket)};
    }

    void OnDocumentStart(const YAML::Mark& /*mark*/) override {}
    void OnDocumentEnd() override {}

    void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
        const bool key = !open_.empty() && open_.back().node.is_mapping() && !open_.back().has_key;
        if (key && tell_long_key(offset(mark), places_, diagnostics_)) throw ParsingEnded{};
        YamlNode node;
        node.place = place(mark);
        const std::string_view rest = places_.text().substr(offset(mark));
        if (anchor != 0) refuse_bare_anchor(node.place);
        const std::string_view word = rest.substr(0, rest.find_first_of(" \t\r\n,]}"));
        const bool written = word == "~" || word == "null" || word == "Null" || word == "NULL";
        if (!written && expects_value()) node.place = open_.back().key_place;
        add(std::move(node), anchor);
    }

    void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  const std::string& value) override {
        if (tag != "!" && tag != "?") refuse_tag(place(mark), tag);
        const std::size_t begin = skip_anchor(places_.text(), offset(mark));
        const std::string_view source = places_.text().substr(begin);
        YamlNode node;
        node.kind = YamlNode::Kind::scalar;
        node.text = value;
        node.place = places_.at(begin);
        node.quoted = tag == "!";

        const bool quote = !source.empty() && (source.front() == '"' || source.front() == '\'');
        if (node.quoted && quote) {
            const std::size_t end = end_of_quoted(source, 0);
            if (end == std::string_view::npos) end_with_open_quote(node.place, source.front());
            if (source.substr(1, end - 2) == value) node.text_column = node.place.column + 1;
            node.place.length = count_characters(first_line(source.substr(0, end)));
        } else if (source.substr(0, value.size()) == value) {
            node.text_column = node.place.column;
            node.place.length = std::max(1, count_characters(value));
        } else {
            node.place.length = std::max(1, count_characters(first_line(source)));
        }
        if (node.text.find('\n') != std::string::npos) node.text_column = 0;
        add(std::move(node), anchor);
    }

    void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
        const std::string_view source = places_.text().substr(offset(mark));
        const std::string_view written = source.substr(0, source.find_first_of(" \t\r\n,]}"));
        const Place here = places_.at(offset(mark), count_characters(written));
        const auto found = anchors_.find(anchor);
        if (found == anchors_.end()) {
            diagnostics_.error(here,
                               fmt::format("the alias '{}' stands inside of its own anchor",
                                           shown(std::string(written))),
                               "write out what it stands for");
            throw ParsingEnded{};
        }
        count_copy(found->second, here);
        YamlNode node = found->second;
        node.place = here;
        node.text_column = 0;
        add(std::move(node), 0);
    }

    void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                         YAML::EmitterStyle::value style) override {
        open(YamlNode::Kind::sequence, mark, tag, anchor, style);
    }
    void OnSequenceEnd() override { close(); }
    void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                    YAML::EmitterStyle::value style) override {
        open(YamlNode::Kind::mapping, mark, tag, anchor, style);
    }
    void OnMapEnd() override { close(); }

private:
    struct OpenNode {
        YamlNode node;
        YAML::anchor_t anchor = 0;
        bool flow = false;
        bool has_key = false;  ///< a mapping's key was read, its value not yet
        std::string key;
        Place key_place;
        std::map<std::string, Place> keys;
    };

    std::size_t offset(const YAML::Mark& mark) const {
        const std::size_t given = mark.pos < 0 ? 0 : static_cast<std::size_t>(mark.pos);
        return std::min(given, places_.text().size());
    }
    Place place(const YAML::Mark& mark) const { return places_.at(offset(mark)); }

    /// As much of its first line as a caret may mark.
    static std::string_view first_line(std::string_view text) {
        constexpr std::size_t longest = 1000;
        text = text.substr(0, longest);
        return text.substr(0, text.find_first_of("\r\n"));
    }

    bool expects_value() const { return !open_.empty() && open_.back().has_key; }

    void open(YamlNode::Kind kind, const YAML::Mark& mark, const std::string& tag,
              YAML::anchor_t anchor, YAML::EmitterStyle::value style) {
        if (!tag.empty() && tag != "?" && tag != "!") refuse_tag(place(mark), tag);
        OpenNode node;
        node.node.kind = kind;
        node.node.place = places_.at(skip_anchor(places_.text(), offset(mark)));
        node.anchor = anchor;
        node.flow = style == YAML::EmitterStyle::Flow;
        if (open_.size() >= maximum_depth) {
            diagnostics_.error(node.node.place,
                               fmt::format("nested more than {} deep", maximum_depth),
                               "no case needs that; check the brackets and the indentation");
            throw ParsingEnded{};
        }
        open_.push_back(std::move(node));
    }

    void close() {
        OpenNode done = std::move(open_.back());
        open_.pop_back();
        add(std::move(done.node), done.anchor);
    }

    void add(YamlNode node, YAML::anchor_t anchor) {
        if (++nodes_ > maximum_nodes) {
            diagnostics_.error(node.place, fmt::format("more than {} values", maximum_nodes),
                               "put lists of points into files of their own");
            throw ParsingEnded{};
        }
        if (anchor != 0) {
            count_copy(node, node.place);
            anchors_[anchor] = node;
        }
        if (open_.empty()) {
            root_ = std::move(node);
            return;
        }
        OpenNode& parent = open_.back();
        if (parent.node.is_sequence()) {
            std::vector<YamlNode>& items = parent.node.children;
            if (!items.empty() && mend_slip_in_list(items.back(), node, diagnostics_)) return;
            items.push_back(std::move(node));
        } else if (!parent.has_key) {
            set_key(parent, node);
        } else {
            add_value(parent, std::move(node));
        }
    }

    /// Every anchored node is kept a second time, and once more at each of its aliases.
    void count_copy(const YamlNode& node, const Place& where) {
        copied_ += size_of_copy(node);
        if (copied_ <= maximum_copied) return;
        diagnostics_.error(where, "anchors and their aliases make this file too large",
                           fmt::format("they stand for more than {} values here; put lists of "
                                       "points into files of their own",
                                       maximum_copied));
        throw ParsingEnded{};
    }

    void set_key(OpenNode& parent, const YamlNode& node) {
        if (!node.is_scalar()) {
            diagnostics_.error(node.place, "a key must be a name", "write NAME: VALUE");
            throw ParsingEnded{};
        }
        parent.has_key = true;
        parent.key = node.text;
        parent.key_place = node.place;
    }

    void add_value(OpenNode& parent, YamlNode node) {
        parent.has_key = false;
        node.key = std::move(parent.key);
        node.key_place = parent.key_place;
        std::vector<YamlNode>& children = parent.node.children;
        if (mend_slip(children.empty() ? nullptr : &children.back(), node, diagnostics_)) return;
        const auto [first, is_new] = parent.keys.emplace(node.key, node.key_place);
        if (!is_new) {
            Diagnostic& d = diagnostics_.error(
                node.key_place, fmt::format("the key '{}' is given twice", shown(node.key)),
                "leave one out, or give it another name");
            d.notes.push_back({first->second, "first given here"});
            return;
        }
        children.push_back(std::move(node));
    }

    void refuse_tag(const Place& where, const std::string& tag) {
        diagnostics_.error(where,
                           fmt::format("YAML tags such as '{}' have no meaning here", shown(tag)),
                           "remove the tag, or quote the text");
    }

    [[noreturn]] void refuse_bare_anchor(const Place& where) {
        diagnostics_.error(where, "'&' begins a YAML anchor, and nothing follows it",
                           "a text that begins with '&' must be quoted");
        throw ParsingEnded{};
    }

    [[noreturn]] void end_with_open_quote(const Place& where, char quote) {
        diagnostics_.error(where, "the quote that opens here is never closed",
                           fmt::format("close it with {}", quote));
        throw ParsingEnded{};
    }

    const SourcePlaces& places_;
    Diagnostics& diagnostics_;
    YamlNode root_;
    std::vector<OpenNode> open_;
    std::map<YAML::anchor_t, YamlNode> anchors_;
    std::size_t copied_ = 0;
    std::size_t nodes_ = 0;
};

bool check_length(const std::shared_ptr<const SourceFile>& source, Diagnostics& diagnostics) {
    if (source->text.size() <= longest_text) return true;
    diagnostics.error(
        {source, 0, 0, 1},
        fmt::format("the file has more than the {} bytes that a case may have", longest_text),
        "put lists of points into files of their own");
    return false;
}

/// Reads one document; false when it did not come to its end.
bool handle_document(YAML::Parser& parser, const SourcePlaces& places, TreeBuilder& builder,
                     Diagnostics& diagnostics, bool& found) {
    try {
        found = parser.HandleNextDocument(builder);
        return true;
    } catch (const ParsingEnded&) {
        return false;
    } catch (const YAML::Exception& fault) {
        tell_syntax_error(fault, places, builder.open_bracket(), diagnostics);
        return false;
    }
}

}  // namespace

const YamlNode* YamlNode::find(std::string_view wanted) const {
    const auto found = std::find_if(children.begin(), children.end(),
                                    [&](const YamlNode& child) { return child.key == wanted; });
    return is_mapping() && found != children.end() ? &*found : nullptr;
}

std::optional<YamlNode> read_yaml(const std::shared_ptr<const SourceFile>& source,
                                  Diagnostics& diagnostics) {
    if (!check_length(source, diagnostics)) return std::nullopt;
    const SourcePlaces places(source);
    if (!check_text(places, diagnostics)) return std::nullopt;

    // With a line end behind it, an open quote is not yaml-cpp's fault but ours, and well placed.
    std::istringstream stream{std::string(places.text()) + "\n"};
    YAML::Parser parser(stream);
    TreeBuilder builder(places, diagnostics);
    bool found = false;
    if (!handle_document(parser, places, builder, diagnostics, found)) return std::nullopt;
    YamlNode root = builder.take_root();
    if (!found || root.is_null()) {
        diagnostics.error({source, 0, 0, 1}, "the file is empty",
                          "`hexweave init NAME` writes a case to begin with");
        return std::nullopt;
    }
    if (!check_nothing_follows(parser, places, diagnostics)) return std::nullopt;
    return root;
}

}  // namespace hexweave
