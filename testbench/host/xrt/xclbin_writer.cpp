#include "xclbin_writer.hpp"

#include <fmt/format.h>
#include <xclbin.h>

#include <cstddef>
#include <cstring>

namespace sailmap::testing {
namespace {

constexpr unsigned first_offset = 0x10;

// Of the instance of a kernel, by its place in the file.
unsigned base_address(std::size_t kernel) { return 0x1000000 + 0x10000 * static_cast<unsigned>(kernel); }

template <class T>
std::string bytes_of(const T& value) {
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

std::string metadata_of(const XclbinKernel& kernel, std::size_t place) {
  std::string xml = fmt::format(
      "<kernel name=\"{0}\" language=\"c\"><port name=\"S_AXI_CONTROL\" mode=\"slave\" range=\"0x1000\" "
      "dataWidth=\"32\" portType=\"addressable\" base=\"0x0\"/>",
      kernel.name);
  for (std::size_t i = 0; i < kernel.buffers; ++i) {
    xml += fmt::format(
        "<port name=\"M_AXI_GMEM{}\" mode=\"master\" range=\"0xFFFFFFFF\" dataWidth=\"64\" "
        "portType=\"addressable\" base=\"0x0\"/>",
        i);
  }
  unsigned offset = first_offset;
  for (std::size_t i = 0; i < kernel.arguments.size(); ++i) {
    const bool buffer = i < kernel.buffers;
    xml += fmt::format(
        "<arg name=\"{}\" addressQualifier=\"{}\" id=\"{}\" port=\"{}\" size=\"{:#x}\" offset=\"{:#x}\" "
        "hostOffset=\"0x0\" hostSize=\"{:#x}\" type=\"{}\"/>",
        kernel.arguments[i], buffer ? 1 : 0, i, buffer ? fmt::format("M_AXI_GMEM{}", i) : "S_AXI_CONTROL",
        buffer ? 8 : 4, offset, buffer ? 8 : 4, buffer ? "void*" : "uint");
    offset += buffer ? 12 : 8;
  }
  return xml + fmt::format(
                   "<instance name=\"{}_1\"><addrRemap base=\"{:#x}\" range=\"0x1000\" "
                   "port=\"S_AXI_CONTROL\"/></instance></kernel>",
                   kernel.name, base_address(place));
}

// What v++ writes about kernels, as far as XRT reads it.
std::string metadata(const std::vector<XclbinKernel>& kernels) {
  std::string xml =
      "<?xml version=\"1.0\"?>\n<project name=\"sailmap\"><platform><device fpgaDevice=\"none\"><core "
      "name=\"OCL_REGION_0\">";
  for (std::size_t k = 0; k < kernels.size(); ++k) xml += metadata_of(kernels[k], k);
  return xml + "</core></device></platform></project>\n";
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

// A table of xclbin.h: its head, which ends where the first of its entries begins, and these entries.
template <class Table, class Entry>
std::string table_of(const Table& head, std::size_t head_bytes, const std::vector<Entry>& entries) {
  std::string out = bytes_of(head).substr(0, head_bytes);
  for (const Entry& entry : entries) out += bytes_of(entry);
  return out;
}

std::string layout(const std::vector<XclbinKernel>& kernels) {
  ip_layout layout{};
  layout.m_count = static_cast<std::int32_t>(kernels.size());
  std::vector<ip_data> instances;
  for (std::size_t k = 0; k < kernels.size(); ++k) {
    ip_data& instance = instances.emplace_back();
    instance.m_type = IP_KERNEL;
    instance.properties = AP_CTRL_HS << IP_CONTROL_SHIFT;
    instance.m_base_address = base_address(k);
    const std::string name = kernels[k].name + ":" + kernels[k].name + "_1";
    std::strncpy(reinterpret_cast<char*>(instance.m_name), name.c_str(), sizeof instance.m_name - 1);
  }
  return table_of(layout, offsetof(ip_layout, m_ip_data), instances);
}

// Each buffer to the one bank of memory.
std::string connections(const std::vector<XclbinKernel>& kernels) {
  connectivity table{};
  std::vector<connection> all;
  for (std::size_t k = 0; k < kernels.size(); ++k) {
    for (std::size_t i = 0; i < kernels[k].buffers; ++i) {
      all.push_back({static_cast<std::int32_t>(i), static_cast<std::int32_t>(k), 0});
    }
  }
  table.m_count = static_cast<std::int32_t>(all.size());
  return table_of(table, offsetof(connectivity, m_connection), all);
}

struct Section {
  axlf_section_kind kind;
  const char* name;
  std::string data;
};

}  // namespace

std::string xclbin_of(const std::vector<XclbinKernel>& kernels) {
  const std::vector<Section> sections = {{EMBEDDED_METADATA, "metadata", metadata(kernels)},
                                         {MEM_TOPOLOGY, "memory", memory_topology()},
                                         {IP_LAYOUT, "ip", layout(kernels)},
                                         {CONNECTIVITY, "connectivity", connections(kernels)},
                                         {ASK_GROUP_TOPOLOGY, "group_memory", memory_topology()},
                                         {ASK_GROUP_CONNECTIVITY, "group_conn", connections(kernels)},
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
