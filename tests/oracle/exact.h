/* exact.h - the oracle's numbers and vectors (C++). Each question is first decided with intervals of doubles, which
 * bound their own error. If a sign or an end stays uncertain, it is decided with rational numbers. These are lazy: a
 * number keeps an interval and how it was made, and is computed exactly, once, if its interval does not decide. */
#ifndef ROBERTS_TESTS_EXACT_H
#define ROBERTS_TESTS_EXACT_H

#include <cmath>
#include <cstddef>

#include <CGAL/Exact_rational.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Lazy_exact_nt.h>

#include "roberts.h"

namespace
{

using interval = CGAL::Interval_nt_advanced;
using rational = CGAL::Lazy_exact_nt<CGAL::Exact_rational>;
/* to_double() of such a number is exact to the last bit, as that of Exact_rational is. */
const bool exact_doubles = (rational::set_relative_precision_of_to_double(1e-17), true);

using uncertain = CGAL::Uncertain_conversion_exception;

template <class N> struct vec {
    N x, y, z;
};

template <class N> vec<N> sub(const roberts_vec3 &p, const roberts_vec3 &q)
{
    return {N(p.x) - N(q.x), N(p.y) - N(q.y), N(p.z) - N(q.z)};
}

template <class N> vec<N> plus(const vec<N> &a, const vec<N> &b)
{
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}

template <class N> vec<N> minus(const vec<N> &a, const vec<N> &b)
{
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

template <class N> vec<N> cross(const vec<N> &a, const vec<N> &b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class N> N dot(const vec<N> &a, const vec<N> &b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/* Computes work(N()) with intervals, and with rational numbers if that throws. */
template <class W> auto exactly(bool exact_only, size_t *exact, W work) -> decltype(work(rational()))
{
    if (!exact_only) {
        try {
            CGAL::Protect_FPU_rounding<true> upward;
            return work(interval());
        } catch (const uncertain &) {
        }
    }
    ++*exact;
    return work(rational());
}

/* Returns the sign of a number; throws if an interval contains more than one. */
template <class N> int sign_of(const N &x)
{
    CGAL::Sign sign = CGAL::sign(x);
    return sign;
}

/* Returns the double nearest to a value in the interval, to 1e-14. */
inline double rounded(const interval &x)
{
    if (x.sup() - x.inf() > 1e-14)
        throw uncertain("too wide");
    return CGAL::to_double(x);
}

inline double rounded(const rational &x)
{
    return CGAL::to_double(x);
}

/* Returns the length of a vector to a thousandth, which is enough to convert a slack into a bound on g. */
inline double length(const vec<interval> &v)
{
    double x = CGAL::to_double(v.x), y = CGAL::to_double(v.y), z = CGAL::to_double(v.z), l = std::hypot(x, y, z);
    for (const interval &c : {v.x, v.y, v.z})
        if (!(c.sup() - c.inf() <= 1e-4 * l))
            throw uncertain("too wide");
    return l;
}

inline double length(const vec<rational> &v)
{
    return std::hypot(CGAL::to_double(v.x), CGAL::to_double(v.y), CGAL::to_double(v.z));
}

} // namespace

#endif
