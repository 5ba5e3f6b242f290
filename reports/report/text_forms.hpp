#pragma once

#include <string>
#include <string_view>

namespace porowave::reports {

/// A text as HTML shows it, in an element or in an attribute in double quotes. Control characters
/// become spaces.
std::string html_text(std::string_view text);

/// JSON that may stand in an element <script> of HTML: no "<" is left in it. `json` is valid JSON.
std::string json_in_html(const std::string& json);

/// One field of CSV (RFC 4180): in quotes if it must be.
std::string csv_field(std::string_view text);

/// A text as LaTeX prints it, outside of math.
std::string latex_text(std::string_view text);

/// A text as a cell of a table of GitHub's Markdown shows it, on one line.
std::string markdown_text(std::string_view text);

/// One word of a command line of a POSIX shell.
std::string shell_word(std::string_view text);

/// At most `most` characters (UTF-8), the last one of a shortened text an ellipsis; most >= 1.
std::string shortened(std::string_view text, std::size_t most);

/// Standard base64 (RFC 4648) with padding.
std::string base64(std::string_view bytes);

}  // namespace porowave::reports
