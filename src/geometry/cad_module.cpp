// SPDX-License-Identifier: Apache-2.0
// The module that holds Open CASCADE: its one function, and what both formats share.
#include "geometry/cad_module.h"

#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Standard_Failure.hxx>
#include <UnitsMethods.hxx>
#include <algorithm>
#include <array>
#include <exception>
#include <utility>

#include "geometry/cad_readers.h"

namespace hexweave {

void convert_lengths_to(const LengthUnit& unit) {
    // Open CASCADE's names for the units of length_units.
    constexpr std::array<const char*, length_units.size()> names{"M",  "MM", "CM",  "INCH", "FT",
                                                                 "KM", "MI", "MIL", "UM",   "UIN"};
    const auto index = static_cast<std::size_t>(&unit - length_units.data());
    Interface_Static::SetCVal("xstep.cascade.unit", names.at(index));
    UnitsMethods::SetCasCadeLengthUnit(Interface_Static::IVal("xstep.cascade.unit"));
}

namespace {

CadFile read_file(const CadText& text) {
    Message::DefaultMessenger()->ChangePrinters().Clear();
    CadFile file = text.format == CadFormat::iges ? read_iges(text) : read_step(text);
    file.format = text.format;
    if (file.entities.empty()) throw CadFault("it holds neither surfaces nor curves");
    return file;
}

}  // namespace

}  // namespace hexweave

extern "C" void hexweave_read_prepared_cad(const hexweave::CadText& text,
                                           hexweave::CadResult& result) {
    using hexweave::CadFault;
    try {
        result.file = hexweave::read_file(text);
    } catch (const CadFault& fault) {
        result.error = fault.what();
    } catch (const Standard_Failure& failure) {
        result.error = std::string("Open CASCADE cannot read it: ") + failure.GetMessageString();
    } catch (const std::exception& failure) {
        result.error = std::string("it cannot be read: ") + failure.what();
    }
}
