// Stand-in for AMD's ap_axi_sdata.h: one beat of an AXI4-Stream, with the fields of the vendor's type.
#pragma once

#include "ap_int.h"

template <int DataBits, int UserBits, int IdBits, int DestBits>
struct ap_axiu {
  ap_uint<DataBits> data;
  ap_uint<(DataBits + 7) / 8> keep;
  ap_uint<(DataBits + 7) / 8> strb;
  ap_uint<UserBits> user;
  ap_uint<1> last;
  ap_uint<IdBits> id;
  ap_uint<DestBits> dest;
};
