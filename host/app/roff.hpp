// Text in the language of man pages.
#pragma once

#include <string>

namespace sailmap::app {

// Running text: nothing in it is taken for a request or an escape, and `words` in back quotes come out bold.
// Words that begin with a dash keep their dashes as ASCII, so that options can be copied; the rest get
// hyphens. Line ends become breaks.
std::string roff_text(const std::string& text);

// The same, each line on a line of its own, with a line end after the last.
std::string roff_lines(const std::string& text);

// A name as it is typed.
std::string roff_bold(const std::string& name);
// What a name stands for.
std::string roff_italic(const std::string& name);

}  // namespace sailmap::app
