#pragma once
#include <cstddef>
#include <type_traits>
#include <utility>

namespace brewster {

/// Zeroed pages of so many bytes, and what stood on those given (null: nothing). `to` 0: gives them back. Throws
/// std::bad_alloc.
void* resized_pages(void* pages, std::size_t from, std::size_t to);

/// Numbers that are zero until they are written, on whole pages that the kernel hands out when and where they are first
/// touched: filled by several threads, they are cleared by them, too. Growing keeps all numbers and copies none.
template <class Number>
class ZeroedArray {
    static_assert(std::is_trivially_copyable_v<Number>, "zero bytes must be a value, and values may move");

  public:
    ZeroedArray() = default;
    explicit ZeroedArray(std::size_t size) { resize(size); }
    ~ZeroedArray() { resized_pages(data_, capacity_ * sizeof(Number), 0); }
    ZeroedArray(ZeroedArray&& other) noexcept { swap(other); }
    ZeroedArray& operator=(ZeroedArray&& other) noexcept {
        swap(other);
        return *this;
    }

    /// Never shrinks; what is added is zero.
    void resize(std::size_t size) {
        if (size > capacity_) reserve(size > 2 * capacity_ ? size : 2 * capacity_);
        if (size > size_) size_ = size;
    }

    Number& operator[](std::size_t index) { return data_[index]; }
    const Number& operator[](std::size_t index) const { return data_[index]; }
    std::size_t size() const { return size_; }
    Number* data() { return data_; }
    const Number* data() const { return data_; }

  private:
    void reserve(std::size_t capacity) {
        data_ = static_cast<Number*>(resized_pages(data_, capacity_ * sizeof(Number), capacity * sizeof(Number)));
        capacity_ = capacity;
    }
    void swap(ZeroedArray& other) {
        std::swap(data_, other.data_);
        std::swap(size_, other.size_);
        std::swap(capacity_, other.capacity_);
    }

    Number* data_ = nullptr;
    std::size_t size_ = 0, capacity_ = 0;
};

}  // namespace brewster
