#pragma once
/// Read this first: what every sign, axis and unit in optics/ means. Nothing here is code; tests/optics/conventions.cpp
/// fixes each line with a test of its own.
///
/// Field.      Ex = E0x cos(wt - kz + dx), Ey likewise: complex amplitudes carry exp(+i w t), z is the direction of
///             travel.
/// Frame.      (x, y, z) right-handed, z = k the direction of travel, y = k x X. A photon carries k and its x axis only,
///             called the carried axis; both are unit vectors. Directions always follow the light.
/// Looking.    Angles and handedness are those seen by the receiver, who looks towards the source along -k, with x to
///             the right and y up. Positive angles run counter-clockwise, from x towards y.
/// S1.         S1 = <|Ex|^2 - |Ey|^2>: positive along x.
/// S2.         S2 = 2 <E0x E0y cos d>, d = dy - dx: positive along the diagonal from x towards y (+45 degrees).
/// S3.         S3 = 2 <E0x E0y sin d>: positive when the receiver sees the field turn clockwise, right circular light.
///             S2 + i S3 = 2 <conj(Ex) Ey>.
/// Units.      S0 is a power, flux or radiance per band in the scene's unit; S1..S3 share it. Beams add in one frame
///             only.
/// Turning.    The frame by +t: S1' = cos 2t S1 + sin 2t S2, S2' = -sin 2t S1 + cos 2t S2. An element turned by t is
///             R(-t) M R(t). x and -x are the same axis.
///
/// Interface.  `normal` faces the incident photon, cos_theta_i = -k.n >= 0.
/// Index.      eta_t_over_i = n_t / n_i: transmitted over incident, above 1 from air into glass.
/// Axis s.     s = k x n / |k x n| is the x axis before and after the event; p = k x s with each one's own k. So S1 > 0
///             is s-polarized, perpendicular to the plane of incidence.
/// r_p.        rs = (n_i c_i - n_t c_t)/(n_i c_i + n_t c_t), rp = (n_t c_i - n_i c_t)/(n_t c_i + n_i c_t) (Verdet): at
///             normal incidence rp = -rs, because p turns round with k. A mirror met head-on is diag(1,1,-1,-1).
/// Absorption. n - i k with k >= 0, which decays under exp(+i w t). C + i D = conj(rs) rp; a gold mirror at 70 degrees
///             turns S2 = +1 into S3 > 0. Total reflection delays s against p: D > 0 as well.
/// Power.      Rs + Ts = Rp + Tp = 1. Matrices map power to power; transmitted radiance would be n^2 T times the
///             incident.
/// Retarder.   Named by its fast axis; the slow axis lags by the retardance.
///
/// Rough.      m = 2 sigma / tau, the Beckmann slope (called alpha by many renderers): sigma the rms height, tau the
///             correlation length of heights with the correlation exp(-r^2/tau^2). `order` counts in the Poisson
///             mixtures of wave optics. i points to the source (-k), r along the reflected light, h half way between.
/// Bands.      red, green, blue at the wavelengths of base/units.h.
///
/// |                     | here               | Mitsuba 3              | Hecht, Optics          | thesis (1997)           |
/// |---------------------|--------------------|------------------------|------------------------|-------------------------|
/// | seen by             | receiver           | receiver               | receiver               | receiver                |
/// | S3 > 0              | right circular     | right circular         | right circular (table) | right circular (2.25)   |
/// | time sign           | exp(+i w t)        | same matrices          | exp(+i w t) in metals  | exp(+i w t) (2.1)       |
/// | absorbing index     | n - i k            | same matrices          | n_R - i n_I            | -                       |
/// | r_p at normal inc.  | -r_s               | -r_s (Verdet)          | -r_s                   | -r_s (4.2)              |
/// | x axis at interface | s = k x n          | s, implicit bases      | -                      | s (ch. 7)               |
/// | frame turned by +t  | R(t) above         | rotator(t), same       | -                      | (3.26), "rotator"       |
/// | retarder            | by fast axis       | fast axis x            | -                      | (3.6) fast x, (3.9) y   |
/// | index ratio         | n_t / n_i          | n_t / n_i              | n_ti = n_t / n_i       | n_t / n_i               |
/// | diattenuator takes  | amplitudes         | powers                 | -                      | amplitudes (3.5)        |
/// | roughness           | m = 2 sigma/tau    | alpha = m              | -                      | sigma and tau apart     |
/// | (7.60), (7.61)      | signed turn, 1/2   | -                      | -                      | acos: no sign; no 1/2   |
///
/// Hecht: E. Hecht, Optics, 4th ed., 4.6, 4.8, 8.13. Mitsuba 3: mueller.h and its chapter on polarization. Thesis:
/// S. Sankaranarayanan, Modelling polarized light for computer graphics, Iowa State University, 1997.
