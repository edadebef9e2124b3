#include "part/step/model.h"

namespace stepmill {

std::size_t StepValues::offsetOf(std::size_t place) const {
    std::size_t offset = 0;
    for (; place > 0 && offset < all_.size(); --place)
        offset += 1 + (all_[offset].is(StepValue::Kind::List) ? all_[offset].word : 0);
    return std::min(offset, all_.size());
}

std::size_t StepValues::size() const {
    std::size_t count = 0;
    for (std::size_t offset = 0; offset < all_.size(); ++count)
        offset += 1 + (all_[offset].is(StepValue::Kind::List) ? all_[offset].word : 0);
    return count;
}

const StepValue& StepValues::operator[](std::size_t place) const {
    static const StepValue kNone;
    const std::size_t offset = offsetOf(place);
    return offset < all_.size() ? all_[offset] : kNone;
}

StepValues StepValues::list(std::size_t place) const {
    const std::size_t offset = offsetOf(place);
    if (offset >= all_.size() || !all_[offset].is(StepValue::Kind::List)) return {};
    return StepValues(all_.subspan(offset + 1, all_[offset].word));
}

std::vector<std::uint32_t> StepValues::references() const {
    std::vector<std::uint32_t> ids;
    for (std::size_t offset = 0; offset < all_.size();) {
        const StepValue& value = all_[offset];
        if (value.is(StepValue::Kind::Reference)) ids.push_back(value.word);
        offset += 1 + (value.is(StepValue::Kind::List) ? value.word : 0);
    }
    return ids;
}

std::vector<double> StepValues::numbers() const {
    std::vector<double> numbers;
    for (std::size_t offset = 0; offset < all_.size();) {
        const StepValue& value = all_[offset];
        const bool list = value.is(StepValue::Kind::List);
        if (value.is(StepValue::Kind::Number)) numbers.push_back(value.number);
        if (list && value.word == 1 && all_[offset + 1].is(StepValue::Kind::Number))
            numbers.push_back(all_[offset + 1].number);
        offset += 1 + (list ? value.word : 0);
    }
    return numbers;
}

const std::size_t* StepModel::indexOf(std::uint32_t id) const {
    const auto found = index_of_id_.find(id);
    return found == index_of_id_.end() ? nullptr : &found->second;
}

const StepEntity* StepModel::find(std::uint32_t id) const {
    const std::size_t* index = indexOf(id);
    return index ? &entities_[*index] : nullptr;
}

std::span<const StepRecord> StepModel::recordsOf(const StepEntity& entity) const {
    return std::span(records_).subspan(entity.first, entity.last - entity.first);
}

const StepRecord* StepModel::record(const StepEntity& entity, std::string_view keyword) const {
    for (const StepRecord& record : recordsOf(entity))
        if (record.keyword == keyword) return &record;
    return nullptr;
}

StepValues StepModel::valuesOf(const StepRecord& record) const {
    return StepValues(std::span(values_).subspan(record.first, record.last - record.first));
}

std::span<const StepValue> StepModel::allValuesOf(const StepEntity& entity) const {
    if (entity.first == entity.last) return {};
    const std::uint32_t begin = records_[entity.first].first;
    return std::span(values_).subspan(begin, records_[entity.last - 1].last - begin);
}

std::string_view StepModel::keywordOf(const StepEntity& entity) const {
    return entity.first == entity.last ? std::string_view{} : records_[entity.first].keyword;
}

}  // namespace stepmill
