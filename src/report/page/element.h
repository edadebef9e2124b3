#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// Markup is made here and nowhere else. Text stays text: whatever a page's author adds as a string is escaped
// when the page is written, and only an Element becomes a tag.

namespace stepmill::report {

/// How a tag is written.
enum class TagKind : std::uint8_t {
    Block,   ///< a line of its own
    Inline,  ///< within a line of text
    Void,    ///< without content and end, such as <meta>
    Shape,   ///< of a drawing: closed at once where it is empty
};

/// A tag of our pages and its classes, written as in a style sheet: "p", "td.n", "svg.drawing.wide".
/// A literal that is checked while compiling; a tag that kTags does not have does not compile.
class Tag {
  public:
    consteval Tag(const char* selector);  // not explicit: stands for the literal

    constexpr std::string_view name() const { return name_; }
    constexpr TagKind kind() const { return kind_; }
    /// The classes with a point between two; empty without any.
    constexpr std::string_view classes() const { return classes_; }

  private:
    std::string_view name_;
    std::string_view classes_;
    TagKind kind_ = TagKind::Inline;
};

/// The name of an attribute: a literal that is checked while compiling. What could run a script, load a file
/// or break the page's policy (on..., style, src, href) does not compile; links and ids are made of anchors.
class AttributeName {
  public:
    consteval AttributeName(const char* name);  // not explicit: stands for the literal

    constexpr std::string_view text() const { return text_; }

  private:
    std::string_view text_;
};

/// A place of a page that links lead to, such as ("feature", "S1.F1"). Each pair has an id of its own,
/// whatever characters the name has.
class Anchor {
  public:
    Anchor(std::string_view kind, std::string_view name);

    /// Letters, digits, '-', '.' and '_'.
    const std::string& id() const { return id_; }

  private:
    std::string id_;
};

/// An element of a page or a drawing with its attributes and what stands in it.
///
///     Element("p.soft", "Machined in ", Element("b", setup.id), ".")
class Element {
  public:
    /// \param content  strings, elements, and lists and options of elements
    template <typename... Content>
    explicit Element(Tag tag, Content&&... content);

    /// Adds text, an element, all elements of a list, or the element of an option where there is one.
    template <typename... Content>
    Element& add(Content&&... content);

    /// Adds an attribute. A second "class" adds to the first; any other attribute may stand once.
    Element& set(AttributeName name, std::string value);
    /// Makes the element the place that links to the anchor lead to.
    /// \pre no other element of the page is
    Element& mark(const Anchor& anchor);

    /// The same for an element that is just being made.
    Element with(AttributeName name, std::string value) &&;
    Element at(const Anchor& anchor) &&;

    /// Is nothing in it?
    bool empty() const { return content_.empty(); }

    /// As HTML, which is well-formed XML too. The same element gives the same bytes.
    std::string markup() const;

    /// A link within the page.
    friend Element linkTo(const Anchor& anchor, std::string text);
    /// A style sheet as it is: what stands in it is ours, no text of strangers.
    friend Element styleElement(std::string_view sheet);
    /// A script as it is: ours, no text of strangers. Where it has "<" or "&" it says itself how a reader of
    /// XML takes them.
    friend Element scriptElement(std::string_view script);
    /// JSON for a script of the page, which finds it by the anchor's id. It is data to a browser, whatever
    /// stands in it.
    friend Element dataElement(const Anchor& anchor, std::string_view json);

  private:
    struct Attribute {
        std::string_view name;
        std::string value;
    };
    enum class Form : std::uint8_t { Tagged, Text, AsItIs };

    Element(Form form, std::string text) : form_(form), text_(std::move(text)) {}
    /// A <script>: no tag of kTags, so that no page can have one by mistake.
    static Element script(std::string text);

    void addOne(Element child) { content_.push_back(std::move(child)); }
    void addOne(std::string text) { content_.push_back(Element(Form::Text, std::move(text))); }
    void addOne(const char* text) { addOne(std::string(text)); }
    void addOne(std::optional<Element> child);
    void addOne(std::vector<Element> children);
    void setNamed(std::string_view name, std::string value);
    void addClasses(std::string_view classes);

    void write(std::string& page) const;
    void writeTagged(std::string& page) const;

    Form form_ = Form::Tagged;
    TagKind kind_ = TagKind::Inline;
    std::string_view name_;
    std::string text_;
    std::vector<Attribute> attributes_;
    std::vector<Element> content_;
};

Element linkTo(const Anchor& anchor, std::string text);
Element styleElement(std::string_view sheet);
Element scriptElement(std::string_view script);
Element dataElement(const Anchor& anchor, std::string_view json);

// Below: what the declarations above promise to check while compiling.

struct KnownTag {
    std::string_view name;
    TagKind kind;
};

/// All tags of our pages.
constexpr KnownTag kTags[] = {
    {"html", TagKind::Block},    {"head", TagKind::Block},    {"meta", TagKind::Void},
    {"title", TagKind::Block},   {"style", TagKind::Block},   {"body", TagKind::Block},
    {"main", TagKind::Block},    {"nav", TagKind::Block},     {"section", TagKind::Block},
    {"h1", TagKind::Block},      {"h2", TagKind::Block},      {"h3", TagKind::Block},
    {"p", TagKind::Block},       {"div", TagKind::Block},     {"ul", TagKind::Block},
    {"li", TagKind::Block},      {"table", TagKind::Block},   {"thead", TagKind::Block},
    {"tbody", TagKind::Block},   {"tr", TagKind::Block},      {"th", TagKind::Inline},
    {"td", TagKind::Inline},     {"figure", TagKind::Block},  {"figcaption", TagKind::Block},
    {"details", TagKind::Block}, {"summary", TagKind::Block}, {"b", TagKind::Inline},
    {"i", TagKind::Inline},      {"span", TagKind::Inline},   {"a", TagKind::Inline},
    {"svg", TagKind::Shape},     {"g", TagKind::Shape},       {"path", TagKind::Shape},
    {"circle", TagKind::Shape},  {"line", TagKind::Shape},    {"rect", TagKind::Shape},
    {"text", TagKind::Shape},    {"input", TagKind::Void},    {"select", TagKind::Block},
    {"option", TagKind::Block},  {"button", TagKind::Inline}, {"noscript", TagKind::Block},
};

/// Not constant, so that a literal which calls them does not compile.
void tagIsNotOneOfOurPages();
void attributeIsNotAllowed();

consteval Tag::Tag(const char* selector) {
    const std::string_view text(selector);
    const std::size_t point = text.find('.');
    name_ = text.substr(0, point);
    if (point != std::string_view::npos) classes_ = text.substr(point + 1);
    bool known = false;
    for (const KnownTag& tag : kTags)
        if (tag.name == name_) {
            kind_ = tag.kind;
            known = true;
        }
    if (!known) tagIsNotOneOfOurPages();
}

consteval AttributeName::AttributeName(const char* name) : text_(name) {
    for (const char c : text_)
        if (!((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-'))
            attributeIsNotAllowed();
    for (const std::string_view refused : {"style", "src", "href", "id"})
        if (text_ == refused) attributeIsNotAllowed();
    if (text_.empty() || text_.starts_with("on")) attributeIsNotAllowed();
}

template <typename... Content>
Element::Element(Tag tag, Content&&... content) : kind_(tag.kind()), name_(tag.name()) {
    addClasses(tag.classes());
    add(std::forward<Content>(content)...);
}

template <typename... Content>
Element& Element::add(Content&&... content) {
    (addOne(std::forward<Content>(content)), ...);
    return *this;
}

}  // namespace stepmill::report
