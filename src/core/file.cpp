#include "stepmill/core/file.h"

#include <array>
#include <bit>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <iomanip>
#include <sstream>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "stepmill/core/error.h"

namespace stepmill {
namespace {

/// A file descriptor that closes itself.
class Descriptor {
  public:
    explicit Descriptor(int fd) : fd_(fd) {}
    Descriptor(Descriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (fd_ >= 0) ::close(fd_);
    }
    int get() const { return fd_; }
    bool open() const { return fd_ >= 0; }
    /// Closes now; false when the system reports a late write error.
    bool close() {
        const int result = ::close(fd_);
        fd_ = -1;
        return result == 0;
    }

  private:
    int fd_;
};

std::string systemReason(int error_number) {
    return std::strerror(error_number);
}

bool writeAll(int fd, std::string_view bytes, Disk& disk) {
    while (!bytes.empty()) {
        const ssize_t written = disk.write(fd, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return false;
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
}

constexpr std::array<std::uint32_t, 64> kRoundConstants = {
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
    0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
    0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
    0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
    0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
    0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2};

using HashState = std::array<std::uint32_t, 8>;

/// One 64-byte block of FIPS 180-4, section 6.2.2.
void compress(HashState& state, const unsigned char* block) {
    std::array<std::uint32_t, 64> w{};
    for (std::size_t t = 0; t < 16; ++t) {
        w[t] = (std::uint32_t{block[4 * t]} << 24) | (std::uint32_t{block[4 * t + 1]} << 16) |
               (std::uint32_t{block[4 * t + 2]} << 8) | std::uint32_t{block[4 * t + 3]};
    }
    for (std::size_t t = 16; t < 64; ++t) {
        const std::uint32_t s0 = std::rotr(w[t - 15], 7) ^ std::rotr(w[t - 15], 18) ^ (w[t - 15] >> 3);
        const std::uint32_t s1 = std::rotr(w[t - 2], 17) ^ std::rotr(w[t - 2], 19) ^ (w[t - 2] >> 10);
        w[t] = w[t - 16] + s0 + w[t - 7] + s1;
    }
    auto [a, b, c, d, e, f, g, h] = state;
    for (std::size_t t = 0; t < 64; ++t) {
        const std::uint32_t big1 = std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25);
        const std::uint32_t choice = (e & f) ^ (~e & g);
        const std::uint32_t t1 = h + big1 + choice + kRoundConstants[t] + w[t];
        const std::uint32_t big0 = std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22);
        const std::uint32_t majority = (a & b) ^ (a & c) ^ (b & c);
        h = g;
        g = f;
        f = e;
        e = d + t1;
        d = c;
        c = b;
        b = a;
        a = t1 + big0 + majority;
    }
    const HashState add = {a, b, c, d, e, f, g, h};
    for (std::size_t i = 0; i < 8; ++i)
        state[i] += add[i];
}

}  // namespace

namespace {

/// What a name stands for that is no file; empty for a file.
std::string kindBeside(mode_t mode) {
    if (S_ISREG(mode)) return {};
    if (S_ISDIR(mode)) return "is a folder, not a file";
    if (S_ISFIFO(mode)) return "is a pipe, not a file";
    if (S_ISSOCK(mode)) return "is a socket, not a file";
    return "is a device, not a file";
}

void requireFile(const std::filesystem::path& path, int result, const struct stat& status) {
    if (result != 0) throw Error(ErrorCode::FileUnreadable, path.string(), systemReason(errno));
    const std::string kind = kindBeside(status.st_mode);
    if (!kind.empty()) throw Error(ErrorCode::FileUnreadable, path.string(), kind);
}

std::string megabytes(std::uintmax_t bytes) {
    std::ostringstream text;
    text << std::setprecision(4) << static_cast<double>(bytes) / (1 << 20) << " MB";
    return text.str();
}

void requireSize(const std::filesystem::path& path, std::uintmax_t bytes, std::uintmax_t max_bytes) {
    if (bytes <= max_bytes) return;
    throw Error(
        ErrorCode::FileUnreadable, path.string(),
        "is larger than the " + megabytes(max_bytes) + " a file may have; allow more with --max-file-size");
}

/// Looks before it opens, since opening some devices does something; looks again at what was opened. A pipe
/// that took the file's place in between does not hang it.
Descriptor openFile(const std::filesystem::path& path, std::uintmax_t max_bytes) {
    struct stat status {};
    requireFile(path, ::stat(path.c_str(), &status), status);
    Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY));
    if (!file.open()) throw Error(ErrorCode::FileUnreadable, path.string(), systemReason(errno));
    requireFile(path, ::fstat(file.get(), &status), status);
    requireSize(path, static_cast<std::uintmax_t>(status.st_size), max_bytes);
    return file;
}

}  // namespace

std::string readFile(const std::filesystem::path& path, std::uintmax_t max_bytes) {
    const Descriptor file = openFile(path, max_bytes);
    std::string bytes;
    std::array<char, 65536> buffer;
    while (true) {
        const ssize_t got = ::read(file.get(), buffer.data(), buffer.size());
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) throw Error(ErrorCode::FileUnreadable, path.string(), systemReason(errno));
        if (got == 0) return bytes;
        bytes.append(buffer.data(), static_cast<std::size_t>(got));
        requireSize(path, bytes.size(), max_bytes);  // it may grow while it is read
    }
}

void writeFile(const std::filesystem::path& path, std::string_view bytes) {
    std::filesystem::path temporary = path;
    temporary += '.';
    temporary += std::to_string(::getpid());
    temporary += ".part";
    const auto fail = [&](int error_number) {
        ::unlink(temporary.c_str());
        throw Error(ErrorCode::OutputUnwritable, path.string(), systemReason(error_number));
    };
    ::unlink(temporary.c_str());  // left over from a killed run with our process id
    Descriptor file(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (!file.open()) throw Error(ErrorCode::OutputUnwritable, path.string(), systemReason(errno));
    if (!writeAll(file.get(), bytes, systemDisk())) fail(errno);
    if (!file.close()) fail(errno);
    if (::rename(temporary.c_str(), path.c_str()) != 0) fail(errno);
}

std::error_code writeNewFile(const std::filesystem::path& path, std::string_view bytes, Disk& disk) {
    Descriptor file(disk.create(path));
    const bool written =
        file.open() && writeAll(file.get(), bytes, disk) && disk.sync(file.get()) == 0 && file.close();
    return written ? std::error_code() : std::error_code(errno, std::generic_category());
}

void syncFolder(const std::filesystem::path& folder, Disk& disk) {
    const Descriptor file(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (file.open() && disk.sync(file.get()) == 0) return;
    const int why = errno;
    const bool cannot = why == EINVAL || why == ENOTSUP || why == EACCES;
    if (!cannot)
        throw Error(ErrorCode::OutputUnwritable, folder.string(), "cannot be written: " + systemReason(why));
}

std::string sha256(std::string_view bytes) {
    HashState state = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                       0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
    const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
    const std::size_t whole = bytes.size() / 64 * 64;
    for (std::size_t at = 0; at < whole; at += 64)
        compress(state, data + at);

    // Padding: a one bit, zeros, and the length in bits as 64-bit big-endian number.
    std::array<unsigned char, 128> tail{};
    const std::size_t rest = bytes.size() - whole;
    if (rest > 0) std::memcpy(tail.data(), data + whole, rest);
    tail[rest] = 0x80;
    const std::size_t tail_size = rest < 56 ? 64 : 128;
    const std::uint64_t bits = std::uint64_t{bytes.size()} * 8;
    for (std::size_t i = 0; i < 8; ++i)
        tail[tail_size - 1 - i] = static_cast<unsigned char>(bits >> (8 * i));
    for (std::size_t at = 0; at < tail_size; at += 64)
        compress(state, tail.data() + at);

    static constexpr char kDigits[] = "0123456789abcdef";
    std::string hex;
    for (const std::uint32_t word : state) {
        for (int shift = 28; shift >= 0; shift -= 4)
            hex += kDigits[(word >> shift) & 0xf];
    }
    return hex;
}

}  // namespace stepmill
