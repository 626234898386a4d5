// SPDX-License-Identifier: Apache-2.0
// ExactSum adds numbers in double precision without rounding and rounds once, when the sum is read,
// so that the result depends neither on their order nor on how they were divided. The sum is a
// fixed-point number over the whole range of doubles in words of 32 bits (R. M. Neal, Fast exact
// summation using small and large superaccumulators, arXiv:1505.05571, 2015); the upper half of a
// word takes the carries of many additions.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace kerf {

class ExactSum {
 public:
  static constexpr int words = 67;
  // As whole numbers that can be added: the words, and how often a number was not finite.
  using Parts = std::array<std::int64_t, words + 1>;

  void clear() {
    for (int k = first_; k <= last_; ++k) word_[index(k)] = 0;
    first_ = words;
    last_ = -1;
    added_ = 0;
    not_finite_ = 0;
  }

  void add(double x) {
    if (x == 0.0) return;
    const auto bits = std::bit_cast<std::uint64_t>(x);
    auto exponent = static_cast<int>(bits >> mantissa_bits) & most_exponent;
    if (exponent == most_exponent) {
      ++not_finite_;
      return;
    }
    std::uint64_t mantissa = bits & ((std::uint64_t(1) << mantissa_bits) - 1);
    if (exponent == 0)
      exponent = 1;  // a subnormal number
    else
      mantissa |= std::uint64_t(1) << mantissa_bits;
    const int place = exponent - 1, word = place / word_bits, shift = place % word_bits;
    const auto low = static_cast<std::int64_t>((mantissa << shift) & word_mask);
    const auto high = static_cast<std::int64_t>(mantissa >> (word_bits - shift));
    const std::int64_t sign = x < 0.0 ? -1 : 1;
    word_[index(word)] += sign * low;
    word_[index(word + 1)] += sign * high;
    first_ = std::min(first_, word);
    last_ = std::max(last_, word + 1);
    if (++added_ == most_added) carry();
  }
  void add(const ExactSum& other) {
    const std::int64_t beyond = other.added_;
    if (added_ + beyond >= most_added) carry();
    for (int k = other.first_; k <= other.last_; ++k) word_[index(k)] += other.word_[index(k)];
    first_ = std::min(first_, other.first_);
    last_ = std::max(last_, other.last_);
    not_finite_ += other.not_finite_;
    added_ += beyond + 1;
    if (added_ >= most_added) carry();
  }

  // The sum, rounded to the nearest number; not a number where one of the numbers was not finite.
  double value() const {
    if (not_finite_ != 0) return std::numeric_limits<double>::quiet_NaN();
    ExactSum rest = *this;
    rest.carry_all();
    const bool is_negative = rest.word_[index(words - 1)] < 0;
    if (is_negative) {
      for (auto& word : rest.word_) word = -word;
      rest.carry_all();
    }
    const double size = rest.rounded();
    return is_negative ? -size : size;
  }

  // Sums of equal numbers have the same parts, up to carries.
  Parts parts() {
    carry();
    Parts result;
    std::copy(word_.begin(), word_.end(), result.begin());
    result.back() = not_finite_;
    return result;
  }
  static ExactSum of(const Parts& parts) {
    ExactSum sum;
    std::copy(parts.begin(), parts.end() - 1, sum.word_.begin());
    sum.not_finite_ = parts.back();
    sum.first_ = 0;
    sum.last_ = words - 1;
    return sum;
  }

 private:
  static constexpr int word_bits = 32, mantissa_bits = 52, most_exponent = 0x7ff;
  static constexpr std::uint64_t word_mask = 0xffffffff;
  // A half of a mantissa has at most 52 bits, so that so many of them fit into a word.
  static constexpr std::int64_t most_added = 1 << 10;
  static constexpr int lowest_exponent = -1074;  // of the last bit of the first word

  static constexpr std::size_t index(int word) { return static_cast<std::size_t>(word); }

  // Moves what is beyond 32 bits to the next word; the highest used word takes a sign.
  void carry() {
    added_ = 1;
    for (int k = first_; k <= last_; ++k) {
      const std::int64_t beyond = word_[index(k)] >> word_bits;
      if (beyond == 0 || k == words - 1) continue;
      if (k == last_) {
        if (beyond == -1) break;
        ++last_;
      }
      word_[index(k)] -= beyond * (std::int64_t(1) << word_bits);
      word_[index(k + 1)] += beyond;
    }
  }
  // The same up to the last word of all, which alone takes a sign.
  void carry_all() {
    for (int k = 0; k + 1 < words; ++k) {
      const std::int64_t beyond = word_[index(k)] >> word_bits;
      word_[index(k)] -= beyond * (std::int64_t(1) << word_bits);
      word_[index(k + 1)] += beyond;
    }
  }
  // Rounds a sum that is not negative: its first 64 bits, the last of them set if any bit after
  // them is, round as all bits do.
  double rounded() const {
    int top = words - 1;
    while (top > 0 && word_[index(top)] == 0) --top;
    const auto word = [&](int k) {
      return k < 0 ? std::uint64_t(0) : std::uint64_t(word_[index(k)]);
    };
    if (word(top) == 0) return 0.0;
    const int shift = std::countl_zero(static_cast<std::uint32_t>(word(top)));
    const std::uint64_t third = word(top - 2);
    std::uint64_t leading = ((word(top) << word_bits) | word(top - 1)) << shift;
    leading |= third >> (word_bits - shift);
    bool any_after = ((third << shift) & word_mask) != 0;
    for (int k = top - 3; k >= 0; --k) any_after = any_after || word_[index(k)] != 0;
    if (any_after) leading |= 1;
    return std::ldexp(static_cast<double>(leading),
                      word_bits * (top - 1) - shift + lowest_exponent);
  }

  std::array<std::int64_t, words> word_{};
  int first_ = words, last_ = -1;  // of the words that may differ from 0
  std::int64_t added_ = 0;         // since the last carry
  std::int64_t not_finite_ = 0;
};

}  // namespace kerf
