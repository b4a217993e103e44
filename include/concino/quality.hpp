// Quality of polys: metrics, the worst poly, histograms.
#pragma once

#include <concino/quality/histogram.hpp>
#include <concino/quality/mean_ratio.hpp>
#include <concino/quality/metric.hpp>
#include <concino/quality/poly_quality.hpp>
#include <concino/quality/scaled_jacobian.hpp>
#include <concino/quality/worst.hpp>
