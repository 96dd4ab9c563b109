#pragma once
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "base/error.h"

namespace brewster {

static_assert(std::endian::native == std::endian::little, "files are little-endian, as memory is");

/// Numbers one after another, little-endian, without gaps.
class ByteWriter {
  public:
    template <class Number>
    void put(const Number& number) {
        static_assert(std::is_arithmetic_v<Number> || sizeof(Number) == 16, "one number at a time");
        const auto* bytes = reinterpret_cast<const char*>(&number);
        bytes_.append(bytes, sizeof number);
    }
    template <class Number>
    void put_all(const std::vector<Number>& numbers) {
        put_all(numbers.data(), numbers.size());
    }
    template <class Number>
    void put_all(const Number* numbers, std::size_t count) {
        static_assert(std::is_arithmetic_v<Number> || sizeof(Number) == 16, "one kind of number");
        put(static_cast<std::uint64_t>(count));
        bytes_.append(reinterpret_cast<const char*>(numbers), count * sizeof(Number));
    }
    void put_text(std::string_view text) {
        put(static_cast<std::uint64_t>(text.size()));
        bytes_ += text;
    }
    const std::string& bytes() const { return bytes_; }

  private:
    std::string bytes_;
};

/// The same backwards. What is not there is an Error that names the file.
class ByteReader {
  public:
    /// `where`: the file, for messages. Both must outlive the reader.
    ByteReader(std::string_view bytes, std::string_view where) : bytes_(bytes), where_(where) {}

    template <class Number>
    Number get() {
        Number number;
        std::memcpy(&number, take(sizeof number).data(), sizeof number);
        return number;
    }
    template <class Number>
    std::vector<Number> get_all() {
        const auto count = get<std::uint64_t>();
        if (count > bytes_.size() / sizeof(Number)) refuse();
        std::vector<Number> numbers(static_cast<std::size_t>(count));
        const std::string_view from = take(numbers.size() * sizeof(Number));
        if (!numbers.empty()) std::memcpy(numbers.data(), from.data(), from.size());
        return numbers;
    }
    /// Exactly so many.
    template <class Number>
    void get_all(Number* numbers, std::size_t count) {
        if (get<std::uint64_t>() != count) refuse();
        const std::string_view from = take(count * sizeof(Number));
        if (count > 0) std::memcpy(numbers, from.data(), from.size());
    }
    std::string get_text() {
        const auto size = get<std::uint64_t>();
        if (size > bytes_.size()) refuse();
        return std::string(take(static_cast<std::size_t>(size)));
    }
    bool at_end() const { return bytes_.empty(); }

    [[noreturn]] void refuse() const {
        throw Error("its parts contradict each other", std::string(where_), "trace the solution again");
    }

  private:
    std::string_view take(std::size_t size) {
        if (size > bytes_.size()) refuse();
        const std::string_view taken = bytes_.substr(0, size);
        bytes_.remove_prefix(size);
        return taken;
    }

    std::string_view bytes_, where_;
};

}  // namespace brewster
