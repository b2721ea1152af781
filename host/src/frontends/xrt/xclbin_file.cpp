#include "xclbin_file.hpp"

#include <xclbin.h>

#include <cstddef>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <vector>

#include "sailmap/xrt.hpp"

namespace sailmap::fpga {
namespace {

constexpr std::size_t header_bytes = offsetof(axlf, m_sections);

}  // namespace

void check_xclbin(const std::string& path) {
  const auto demand = [&](bool holds, const char* fault) {
    if (!holds) throw DeviceError(path + ": " + fault);
  };
  std::error_code unreadable;
  const std::uintmax_t bytes = std::filesystem::file_size(path, unreadable);
  std::ifstream file(path, std::ios::binary);
  demand(!unreadable && file, "cannot be read");
  axlf head{};
  file.read(static_cast<char*>(static_cast<void*>(&head)), header_bytes);
  demand(std::strncmp(head.m_magic, "xclbin2", sizeof head.m_magic) == 0, "is no xclbin");
  const std::uintmax_t sections = head.m_header.m_numSections;
  demand(file && head.m_header.m_length == bytes && sections <= bytes / sizeof(axlf_section_header),
         "the xclbin is cut off");
  std::vector<axlf_section_header> headers(sections);
  file.read(static_cast<char*>(static_cast<void*>(headers.data())),
            static_cast<std::streamsize>(sections * sizeof(axlf_section_header)));
  demand(file.good(), "the xclbin is cut off");
  for (const axlf_section_header& section : headers) {
    const bool inside =
        section.m_sectionOffset <= bytes && section.m_sectionSize <= bytes - section.m_sectionOffset;
    demand(inside, "a section of the xclbin lies outside the file");
  }
}

}  // namespace sailmap::fpga
