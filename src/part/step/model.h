#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace stepmill {

/// A parameter of an entity. Lists and typed values (LENGTH_MEASURE(1.)) stand before what they hold.
struct StepValue {
    enum class Kind : std::uint8_t { Omitted, Number, Reference, Enumeration, Text, List };
    double number = 0;            ///< of a Number
    const char* begin = nullptr;  ///< of an Enumeration or Text in the file
    std::uint32_t word = 0;       ///< Reference: the id; List: how many values it holds, those of inner lists
                                  ///< too; Enumeration and Text: length
    Kind kind = Kind::Omitted;

    bool is(Kind other) const { return kind == other; }
    /// As written, with its dots or quotes; empty for the other kinds.
    std::string_view text() const { return begin ? std::string_view(begin, word) : std::string_view{}; }
    bool isTrue() const { return text() == ".T."; }
    bool isFalse() const { return text() == ".F."; }
};

/// The parameters of a record or the items of a list, one behind the other.
class StepValues {
  public:
    StepValues() = default;
    explicit StepValues(std::span<const StepValue> all) : all_(all) {}

    /// Of the outermost level.
    std::size_t size() const;
    bool empty() const { return all_.empty(); }
    /// The value at this place of the outermost level; an Omitted one beyond the end.
    const StepValue& operator[](std::size_t place) const;
    /// The items of the list at this place; none where no list stands.
    StepValues list(std::size_t place) const;
    /// Ids of the references at the outermost level.
    std::vector<std::uint32_t> references() const;
    /// The numbers at the outermost level; typed ones (LENGTH_MEASURE(1.)) count too.
    std::vector<double> numbers() const;

  private:
    std::size_t offsetOf(std::size_t place) const;

    std::span<const StepValue> all_;
};

/// KEYWORD(...): an entity has one, a complex entity several.
struct StepRecord {
    std::string_view keyword;
    std::uint32_t first = 0;  ///< of its values
    std::uint32_t last = 0;   ///< behind them
};

struct StepEntity {
    std::uint32_t id = 0;
    int line = 0;
    std::uint32_t first = 0;  ///< of its records
    std::uint32_t last = 0;   ///< behind them
};

/// The entities of a DATA section with their parameters, in file order. Keywords point into the file's text.
class StepModel {
  public:
    const std::vector<StepEntity>& entities() const { return entities_; }
    /// Place of the entity of this id in entities(); nothing if the file does not define it.
    const std::size_t* indexOf(std::uint32_t id) const;
    const StepEntity* find(std::uint32_t id) const;
    std::span<const StepRecord> recordsOf(const StepEntity& entity) const;
    /// The entity's record of this keyword, or null.
    const StepRecord* record(const StepEntity& entity, std::string_view keyword) const;
    StepValues valuesOf(const StepRecord& record) const;
    /// Of all records of the entity, inner values too.
    std::span<const StepValue> allValuesOf(const StepEntity& entity) const;
    /// First keyword; empty for an id that a REFERENCE section brings in.
    std::string_view keywordOf(const StepEntity& entity) const;

  private:
    friend class StepEntityReader;
    std::vector<StepEntity> entities_;
    std::vector<StepRecord> records_;
    std::vector<StepValue> values_;
    std::unordered_map<std::uint32_t, std::size_t> index_of_id_;
};

}  // namespace stepmill
