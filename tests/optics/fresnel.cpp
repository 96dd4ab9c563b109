#include "optics/fresnel.h"

#include <gtest/gtest.h>

#include "reference_table.h"

namespace brewster {
namespace {

/// Fills the columns that dielectric and conductor tables share.
template <class Interface>
void compare_reflection(WorstErrors& errors, const ReferenceTable& table, std::size_t row, const Interface& at,
                        bool relative) {
    const auto compare = [&](const char* column, double value) {
        if (relative)
            errors.relative(column, row, value, table(row, column));
        else
            errors.absolute(column, row, value, table(row, column));
    };
    compare("rs_re", static_cast<double>(at.rs.re));
    compare("rs_im", static_cast<double>(at.rs.im));
    compare("rp_re", static_cast<double>(at.rp.re));
    compare("rp_im", static_cast<double>(at.rp.im));
    compare("ms", static_cast<double>(at.reflection.a));
    compare("md", static_cast<double>(at.reflection.b));
    compare("mc", static_cast<double>(at.reflection.c));
    compare("md_s", static_cast<double>(at.reflection.d));
    errors.relative("Rs", row, static_cast<double>(at.Rs), table(row, "Rs"));
    errors.relative("Rp", row, static_cast<double>(at.Rp), table(row, "Rp"));
}

template <class Real>
void compare_dielectric(WorstErrors& errors) {
    const ReferenceTable table("fresnel_dielectric");
    for (std::size_t row = 0; row < table.size(); ++row) {
        const auto at = dielectric_interface(Real(table(row, "cos_theta")), Real(table(row, "n")));
        compare_reflection(errors, table, row, at, true);
        errors.relative("ts", row, at.ts, table(row, "ts"));
        errors.relative("tp", row, at.tp, table(row, "tp"));
        errors.relative("Ts", row, at.Ts, table(row, "Ts"));
        errors.relative("Tp", row, at.Tp, table(row, "Tp"));
        errors.relative("tx", row, at.transmission.c, table(row, "tx"));
        errors.relative("transmission.b", row, at.transmission.b, table(row, "Ts") == 0 ? 0.0 : -table(row, "md"));
    }
}

TEST(Fresnel, DielectricReference) {
    WorstErrors errors("fresnel_dielectric");
    compare_dielectric<double>(errors);
    EXPECT_LE(errors.worst(), 1e-12);
}

TEST(Fresnel, ConductorReference) {
    const ReferenceTable table("fresnel_conductor");
    WorstErrors errors("fresnel_conductor");
    for (std::size_t row = 0; row < table.size(); ++row)
        compare_reflection(errors, table, row,
                           conductor_interface(table(row, "cos_theta"), table(row, "n"), table(row, "k")), false);
    for (const char* column : {"rs_re", "rs_im", "rp_re", "rp_im", "ms", "md", "mc", "md_s"})
        EXPECT_LE(errors.worst(column), 2e-15) << column;
    EXPECT_LE(errors.worst("Rs"), 1e-12);
    EXPECT_LE(errors.worst("Rp"), 1e-12);
}

TEST(Fresnel, TotalReflectionReference) {
    const ReferenceTable table("tir_retardance");
    WorstErrors errors("tir_retardance");
    for (std::size_t row = 0; row < table.size(); ++row) {
        const auto at = dielectric_interface(table(row, "cos_theta"), table(row, "n"));
        errors.relative("rs_re", row, at.rs.re, table(row, "rs_re"));
        errors.relative("rs_im", row, at.rs.im, table(row, "rs_im"));
        errors.relative("rp_re", row, at.rp.re, table(row, "rp_re"));
        errors.relative("rp_im", row, at.rp.im, table(row, "rp_im"));
        errors.relative("arg_rs", row, std::atan2(at.rs.im, at.rs.re), table(row, "arg_rs"));
        errors.relative("arg_rp", row, std::atan2(at.rp.im, at.rp.re), table(row, "arg_rp"));
        errors.relative("cos_Delta", row, at.reflection.c, table(row, "cos_Delta"));
        errors.relative("sin_Delta", row, at.reflection.d, table(row, "sin_Delta"));
        errors.relative("Delta", row, std::atan2(at.reflection.d, at.reflection.c), table(row, "Delta"));
        errors.relative("tan_half_Delta", row, at.reflection.d / (1 + at.reflection.c), table(row, "tan_half_Delta"));
    }
    EXPECT_LE(errors.worst(), 1e-12);
}

TEST(Fresnel, DegreeOfPolarizationReference) {
    const ReferenceTable table("degree_of_polarization");
    WorstErrors errors("degree_of_polarization");
    for (std::size_t row = 0; row < table.size(); ++row) {
        // The table gives the angle; its cosine carries a rounding, and the angle's own at 90 degrees.
        const auto at = dielectric_interface(std::cos(table(row, "theta_deg") * (pi / 180)), table(row, "n"));
        errors.relative("R_unpolarized", row, at.reflection.a, table(row, "R_unpolarized"));
        errors.relative("P_reflected", row, at.reflection.b / at.reflection.a, table(row, "P_reflected"));
        errors.relative("P_transmitted", row, -at.transmission.b / at.transmission.a, table(row, "P_transmitted"));
        errors.relative("brewster_deg", row, std::atan(table(row, "n")) * (180 / pi), table(row, "brewster_deg"));
    }
    EXPECT_LE(errors.worst(), 1e-12);
}

}  // namespace
}  // namespace brewster
