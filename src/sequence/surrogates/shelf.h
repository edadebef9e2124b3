#pragma once

#include <map>
#include <memory>
#include <mutex>

#include <tbb/task_arena.h>

namespace stepmill {

/// Values made once, by the first who asks for their key; others wait for it. Safe to share between threads.
template <typename Key, typename Value>
class Shelf {
  public:
    template <typename Make>
    const Value& get(const Key& key, Make make) const {
        Place& place = placeOf(key);
        std::call_once(place.once, [&] {
            // A thread that waits for parts of its own work must not take up other work meanwhile: that may
            // ask for this same value.
            tbb::this_task_arena::isolate([&] { place.value = std::make_unique<const Value>(make()); });
        });
        return *place.value;
    }

  private:
    struct Place {
        std::once_flag once;
        std::unique_ptr<const Value> value;
    };

    Place& placeOf(const Key& key) const {
        const std::lock_guard lock(mutex_);
        return places_[key];
    }

    mutable std::mutex mutex_;
    mutable std::map<Key, Place> places_;
};

}  // namespace stepmill
