#include "xclbin_writer.hpp"

#include <fmt/format.h>
#include <xclbin.h>

#include <cstddef>
#include <cstring>

namespace sailmap::testing {
namespace {

constexpr std::size_t buffers = 8;
constexpr unsigned first_offset = 0x10;

template <class T>
std::string bytes_of(const T& value) {
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

// What v++ writes about a kernel, as far as XRT reads it.
std::string metadata(const std::string& kernel, const std::vector<std::string>& arguments) {
  std::string xml = fmt::format(
      "<?xml version=\"1.0\"?>\n<project name=\"{0}\"><platform><device fpgaDevice=\"none\"><core "
      "name=\"OCL_REGION_0\">"
      "<kernel name=\"{0}\" language=\"c\"><port name=\"S_AXI_CONTROL\" mode=\"slave\" range=\"0x1000\" "
      "dataWidth=\"32\" portType=\"addressable\" base=\"0x0\"/>",
      kernel);
  for (std::size_t i = 0; i < buffers; ++i) {
    xml += fmt::format(
        "<port name=\"M_AXI_GMEM{}\" mode=\"master\" range=\"0xFFFFFFFF\" dataWidth=\"64\" "
        "portType=\"addressable\" base=\"0x0\"/>",
        i);
  }
  unsigned offset = first_offset;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const bool buffer = i < buffers;
    xml += fmt::format(
        "<arg name=\"{}\" addressQualifier=\"{}\" id=\"{}\" port=\"{}\" size=\"{:#x}\" offset=\"{:#x}\" "
        "hostOffset=\"0x0\" hostSize=\"{:#x}\" type=\"{}\"/>",
        arguments[i], buffer ? 1 : 0, i, buffer ? fmt::format("M_AXI_GMEM{}", i) : "S_AXI_CONTROL",
        buffer ? 8 : 4, offset, buffer ? 8 : 4, buffer ? "void*" : "uint");
    offset += buffer ? 12 : 8;
  }
  return xml + fmt::format(
                   "<instance name=\"{0}_1\"><addrRemap base=\"0x1000000\" range=\"0x1000\" "
                   "port=\"S_AXI_CONTROL\"/>"
                   "</instance></kernel></core></device></platform></project>\n",
                   kernel);
}

std::string memory_topology() {
  mem_topology topology{};
  topology.m_count = 1;
  mem_data& bank = topology.m_mem_data[0];
  bank.m_type = MEM_DDR4;
  bank.m_used = 1;
  bank.m_size = 1U << 24;  // KiB
  std::strcpy(reinterpret_cast<char*>(bank.m_tag), "bank0");
  return bytes_of(topology);
}

std::string layout(const std::string& kernel) {
  ip_layout layout{};
  layout.m_count = 1;
  ip_data& instance = layout.m_ip_data[0];
  instance.m_type = IP_KERNEL;
  instance.properties = AP_CTRL_HS << IP_CONTROL_SHIFT;
  instance.m_base_address = 0x1000000;
  std::strncpy(reinterpret_cast<char*>(instance.m_name), (kernel + ":" + kernel + "_1").c_str(),
               sizeof instance.m_name - 1);
  return bytes_of(layout);
}

// Each buffer to the one bank of memory.
std::string connections() {
  std::string out = bytes_of(static_cast<std::int32_t>(buffers));
  for (std::size_t i = 0; i < buffers; ++i) out += bytes_of(connection{static_cast<std::int32_t>(i), 0, 0});
  return out;
}

struct Section {
  axlf_section_kind kind;
  const char* name;
  std::string data;
};

}  // namespace

std::string xclbin_of(const std::string& kernel, const std::vector<std::string>& arguments) {
  const std::vector<Section> sections = {{EMBEDDED_METADATA, "metadata", metadata(kernel, arguments)},
                                         {MEM_TOPOLOGY, "memory", memory_topology()},
                                         {IP_LAYOUT, "ip", layout(kernel)},
                                         {CONNECTIVITY, "connectivity", connections()},
                                         {ASK_GROUP_TOPOLOGY, "group_memory", memory_topology()},
                                         {ASK_GROUP_CONNECTIVITY, "group_conn", connections()},
                                         {BITSTREAM, "bitstream", std::string(64, '\0')}};
  axlf head{};
  std::strcpy(head.m_magic, "xclbin2");
  head.m_signature_length = -1;
  head.m_header.m_versionMajor = 2;
  head.m_header.m_numSections = static_cast<std::uint32_t>(sections.size());
  std::memset(head.m_header.uuid, 0x5a, sizeof head.m_header.uuid);
  std::size_t end = offsetof(axlf, m_sections) + sections.size() * sizeof(axlf_section_header);
  std::string headers;
  std::string data;
  for (const Section& section : sections) {
    axlf_section_header header{};
    header.m_sectionKind = section.kind;
    std::strncpy(header.m_sectionName, section.name, sizeof header.m_sectionName - 1);
    const std::string padding((8 - (end + data.size()) % 8) % 8, '\0');
    data += padding;
    header.m_sectionOffset = end + data.size();
    header.m_sectionSize = section.data.size();
    data += section.data;
    headers += bytes_of(header);
  }
  head.m_header.m_length = end + data.size();
  return std::string(reinterpret_cast<const char*>(&head), offsetof(axlf, m_sections)) + headers + data;
}

}  // namespace sailmap::testing
