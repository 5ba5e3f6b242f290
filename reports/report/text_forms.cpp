#include "reports/report/text_forms.hpp"

#include <algorithm>
#include <cctype>
#include <cstdint>

namespace porowave::reports {

namespace {

/// Every character of a text by a function, control characters as spaces.
template <class Form>
std::string each(std::string_view text, Form form) {
  std::string result;
  for (const char c : text) {
    const char shown = static_cast<unsigned char>(c) < ' ' || c == '\x7f' ? ' ' : c;
    result += form(shown);
  }
  return result;
}

std::string html_character(char c) {
  switch (c) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    case '\'':
      return "&#39;";
    default:
      return {c};
  }
}

std::string latex_character(char c) {
  switch (c) {
    case '\\':
      return "\\textbackslash{}";
    case '~':
      return "\\textasciitilde{}";
    case '^':
      return "\\textasciicircum{}";
    case '<':
      return "\\textless{}";
    case '>':
      return "\\textgreater{}";
    case '|':
      return "\\textbar{}";
    case '"':
      return "\\textquotedbl{}";
    default:
      return std::string_view("&%$#_{}").find(c) == std::string_view::npos ? std::string{c}
                                                                           : std::string{'\\', c};
  }
}

}  // namespace

std::string html_text(std::string_view text) {
  return each(text, html_character);
}

std::string json_in_html(const std::string& json) {
  std::string result;
  for (const char c : json) {
    if (c == '<') {
      result += "\\u003c";
    } else {
      result += c;
    }
  }
  return result;
}

std::string csv_field(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? "\"\"" : std::string{c};
  return result + "\"";
}

std::string latex_text(std::string_view text) {
  return each(text, latex_character);
}

std::string markdown_text(std::string_view text) {
  return each(text, [](char c) -> std::string {
    if (c == '<') return "&lt;";
    if (c == '>') return "&gt;";
    if (c == '&') return "&amp;";
    return std::string_view("\\`*_{}[]#|~@").find(c) == std::string_view::npos
               ? std::string{c}
               : std::string{'\\', c};
  });
}

std::string shell_word(std::string_view text) {
  const auto plain = [](unsigned char c) {
    return std::isalnum(c) != 0 ||
           std::string_view("_-./+,=:@%").find(static_cast<char>(c)) != std::string_view::npos;
  };
  if (!text.empty() && std::all_of(text.begin(), text.end(), plain)) return std::string(text);
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? "'\\''" : std::string{c};
  return result + "'";
}

std::string shortened(std::string_view text, std::size_t most) {
  const auto begins = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; };
  const auto length = static_cast<std::size_t>(std::count_if(text.begin(), text.end(), begins));
  if (length <= most) return std::string(text);
  std::size_t kept = 0;
  std::size_t end = 0;
  for (; end < text.size(); ++end) {
    if (begins(text[end]) && kept++ == most - 1) break;
  }
  return std::string(text.substr(0, end)) + "…";
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string result;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      word = word << 8U | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      const bool filled = i + k <= bytes.size();
      result += filled ? digits[word >> (18U - 6U * k) & 63U] : '=';
    }
  }
  return result;
}

}  // namespace porowave::reports
