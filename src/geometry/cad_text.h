// SPDX-License-Identifier: Apache-2.0
// The text of CAD files, before it is read: which format it is, and slips that can be mended.
#pragma once

#include <string>

namespace hexweave {

enum class CadFormat { iges, step };

/// A text of a format, fit to be read; or `error` says why it cannot be.
struct CadText {
    CadFormat format = CadFormat::iges;
    std::string text;
    std::string error;
    /// Of an IGES file: a name of length_units, or empty where the file does not say.
    std::string unit{};
};

/// Tells IGES from STEP by content and checks that the file is whole. Of parameter lines of an IGES
/// file that hold data in column 65, which the standard keeps blank, a blank is removed, so that a
/// reader of 64 columns finds all.
CadText prepare_cad_text(const std::string& text);

}  // namespace hexweave
