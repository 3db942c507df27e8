#pragma once

#include <string>
#include <string_view>

namespace regarment {

/// A length in centimetres with one digit: 0.5437 m is "54.4". Never "-0.0".
std::string cm_text(double metres);

/// The same with its sign, the minus as U+2212: "+1.2", "−0.4", "0.0".
std::string signed_cm_text(double metres);

/// Fixed digits with a sign, the minus as U+2212; zero has none.
std::string signed_text(double value, int digits);

/// Fixed digits after the point, whatever the locale; "-0.0" becomes "0.0".
std::string fixed_text(double value, int digits);

/// `digits` (>= 1) significant digits without an exponent: 0.0123456 with three is "0.0123", 1234.6
/// is "1235". At most 12 digits after the point; zero is "0".
std::string significant_text(double value, int digits);

/// At most three digits after the point, and none that says nothing: 5 is "5", 0.970 is "0.97".
std::string short_text(double value);

/// A count with thin groups of three: 131072 is "131 072" (narrow no-break spaces).
std::string count_text(std::size_t count);

/// A time for a person, to one unit or two: "40 s", "12 min", "3 h 5 min". Seconds, >= 0.
std::string duration_text(double seconds);

/// One argument as a POSIX shell reads it back: `a b` is `'a b'`, `skirt` stays.
std::string shell_quoted(std::string_view argument);

/// Bytes in base64, for data: addresses.
std::string base64(std::string_view bytes);

/// `value` with at most `digits` decimals, for files where more would be noise. Never -0.
double rounded(double value, int digits);

/// `value` to so many significant digits, as `significant_text` writes them.
double rounded_significant(double value, int digits);

}  // namespace regarment
