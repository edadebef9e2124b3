#include <memory>

#include <fmt/format.h>
#include <zip.h>

#include "crib/tool_maker.h"
#include "stepmill/crib/read_foreign.h"

namespace stepmill {
namespace {

/// A library's zip holds a file or two; beyond this it is made to keep its reader busy.
constexpr zip_int64_t kMostEntries = 1000;

struct CloseArchive {
    void operator()(zip_t* archive) const { zip_discard(archive); }
};
struct CloseEntry {
    void operator()(zip_file_t* entry) const { zip_fclose(entry); }
};

bool isJson(std::string_view name) {
    return name.ends_with(".json") || name.ends_with(".JSON");
}

class ZipReader {
  public:
    ZipReader(std::string_view bytes, const std::string& name, std::uintmax_t max_bytes)
        : name_(name), max_bytes_(max_bytes) {
        zip_error_t error;
        zip_error_init(&error);
        zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
        if (source != nullptr) archive_.reset(zip_open_from_source(source, ZIP_RDONLY, &error));
        if (archive_ == nullptr && source != nullptr) zip_source_free(source);
        zip_error_fini(&error);
        if (archive_ == nullptr) fail("expected a zip that holds a tool library, found something else");
    }

    std::string onlyJson() const {
        const zip_int64_t entries = zip_get_num_entries(archive_.get(), 0);
        if (entries > kMostEntries)
            fail(fmt::format("expected at most {} files in the zip, found {}", kMostEntries, entries));
        zip_int64_t json = -1;
        int count = 0;
        for (zip_int64_t i = 0; i < entries; ++i) {
            const char* entry = zip_get_name(archive_.get(), static_cast<zip_uint64_t>(i), ZIP_FL_ENC_RAW);
            if (entry == nullptr || !isJson(entry)) continue;
            json = i;
            ++count;
        }
        if (count != 1) fail(fmt::format("expected one JSON file in the zip, found {}", count));
        return content(static_cast<zip_uint64_t>(json));
    }

  private:
    [[noreturn]] void fail(const std::string& message) const { crib::refuse(name_, "zip", message); }

    /// Sizes that a zip tells of itself are not believed: what comes out is counted.
    std::string content(zip_uint64_t index) const {
        zip_stat_t stat;
        zip_stat_init(&stat);
        if (zip_stat_index(archive_.get(), index, 0, &stat) != 0 || (stat.valid & ZIP_STAT_COMP_SIZE) == 0)
            fail("expected a file that can be read, found a damaged one");
        const std::unique_ptr<zip_file_t, CloseEntry> entry(zip_fopen_index(archive_.get(), index, 0));
        if (entry == nullptr) fail("expected a file that can be read, found one that is damaged or locked");
        const auto most =
            static_cast<std::uintmax_t>(std::max(1.0e6, kMostSwelling * static_cast<double>(stat.comp_size)));
        std::string text;
        std::string part(1U << 16U, '\0');
        for (;;) {
            const zip_int64_t got = zip_fread(entry.get(), part.data(), part.size());
            if (got < 0) fail("expected a file that can be read, found a damaged one");
            if (got == 0) return text;
            text.append(part, 0, static_cast<std::size_t>(got));
            if (text.size() > max_bytes_)
                fail(fmt::format("expected at most {} bytes, found more; --max-file-size allows more",
                                 max_bytes_));
            if (text.size() > most)
                fail(fmt::format("expected a file at most {:g} times its size in the zip, found a zip bomb",
                                 kMostSwelling));
        }
    }

    const std::string& name_;
    std::uintmax_t max_bytes_;
    std::unique_ptr<zip_t, CloseArchive> archive_;
};

}  // namespace

std::string jsonOfZip(std::string_view zip, const std::string& name, std::uintmax_t max_bytes) {
    return ZipReader(zip, name, max_bytes).onlyJson();
}

}  // namespace stepmill
