#include "report/page/element.h"

#include <algorithm>

#include <fmt/format.h>

#include "stepmill/core/error.h"
#include "stepmill/core/plain_text.h"

namespace stepmill::report {
namespace {

/// What stands for a character that means something in markup; empty for all others. Attributes stand in
/// double quotes, so single ones mean nothing.
std::string_view entityFor(char c) {
    switch (c) {
        case '&':
            return "&amp;";
        case '<':
            return "&lt;";
        case '>':
            return "&gt;";
        case '"':
            return "&quot;";
        default:
            return {};
    }
}

/// Does plainText() leave the character as it is, whatever stands beside it?
bool printsInAscii(char c) {
    return c >= 0x20 && c < 0x7F;
}

/// Text that is safe in an element and in a quoted attribute, and fit to be read.
void writeEscaped(std::string& page, std::string_view text) {
    // Paths have a million characters and need nothing done to them.
    const bool plain = std::all_of(text.begin(), text.end(),
                                   [](char c) { return printsInAscii(c) && entityFor(c).empty(); });
    if (plain) {
        page += text;
        return;
    }
    for (const char c : plainText(text)) {
        const std::string_view entity = entityFor(c);
        if (entity.empty())
            page += c;
        else
            page += entity;
    }
}

bool mayStandInAnId(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == '-';
}

}  // namespace

Anchor::Anchor(std::string_view kind, std::string_view name) : id_(std::string(kind) + "-") {
    for (const char c : name)
        if (mayStandInAnId(c))
            id_ += c;
        else
            id_ += fmt::format("_{:02x}", static_cast<unsigned char>(c));
}

void Element::addOne(std::optional<Element> child) {
    if (child) addOne(std::move(*child));
}

void Element::addOne(std::vector<Element> children) {
    for (Element& child : children)
        addOne(std::move(child));
}

void Element::setNamed(std::string_view name, std::string value) {
    const auto there = std::find_if(attributes_.begin(), attributes_.end(),
                                    [&](const Attribute& attribute) { return attribute.name == name; });
    if (there == attributes_.end()) {
        attributes_.push_back({name, std::move(value)});
        return;
    }
    STEPMILL_CHECK(name == "class", "an attribute stands once");
    there->value += " " + value;
}

void Element::addClasses(std::string_view classes) {
    if (classes.empty()) return;
    std::string words(classes);
    std::replace(words.begin(), words.end(), '.', ' ');
    setNamed("class", std::move(words));
}

Element& Element::set(AttributeName name, std::string value) {
    setNamed(name.text(), std::move(value));
    return *this;
}

Element& Element::mark(const Anchor& anchor) {
    setNamed("id", anchor.id());
    return *this;
}

Element Element::with(AttributeName name, std::string value) && {
    set(name, std::move(value));
    return std::move(*this);
}

Element Element::at(const Anchor& anchor) && {
    mark(anchor);
    return std::move(*this);
}

std::string Element::markup() const {
    std::string page;
    write(page);
    return page;
}

void Element::write(std::string& page) const {
    switch (form_) {
        case Form::Tagged:
            return writeTagged(page);
        case Form::Text:
            return writeEscaped(page, text_);
        case Form::AsItIs:
            page += text_;
    }
}

void Element::writeTagged(std::string& page) const {
    const std::string_view line_end = kind_ == TagKind::Inline ? "" : "\n";
    page += '<';
    page += name_;
    for (const Attribute& attribute : attributes_) {
        page += ' ';
        page += attribute.name;
        page += "=\"";
        writeEscaped(page, attribute.value);
        page += '"';
    }
    const bool closed_at_once = kind_ == TagKind::Void || (kind_ == TagKind::Shape && empty());
    if (closed_at_once) {
        page += "/>";
        page += line_end;
        return;
    }
    page += '>';
    for (const Element& child : content_)
        child.write(page);
    page += "</";
    page += name_;
    page += '>';
    page += line_end;
}

Element linkTo(const Anchor& anchor, std::string text) {
    Element link("a", std::move(text));
    link.setNamed("href", "#" + anchor.id());
    return link;
}

Element styleElement(std::string_view sheet) {
    Element style("style");
    style.addOne(Element(Element::Form::AsItIs, std::string(sheet)));
    return style;
}

Element Element::script(std::string text) {
    Element script(Form::Tagged, "");
    script.name_ = "script";
    script.kind_ = TagKind::Block;
    script.addOne(Element(Form::AsItIs, std::move(text)));
    return script;
}

Element scriptElement(std::string_view script) {
    return Element::script(std::string(script));
}

Element dataElement(const Anchor& anchor, std::string_view json) {
    // In JSON these stand within strings alone, where an escape means the same.
    std::string escaped;
    for (const char c : json)
        if (c == '<' || c == '>' || c == '&')
            escaped += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
        else
            escaped += c;
    Element data = Element::script(std::move(escaped));
    data.set("type", "application/json");
    data.mark(anchor);
    return data;
}

}  // namespace stepmill::report
