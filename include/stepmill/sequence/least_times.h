#pragma once

#include <string>
#include <vector>

namespace stepmill {

/// What no sequence of a feature's tools gets below: a DAG over the tools by falling diameter, whose edges
/// hold the least time that a tool cuts after another, without any tool change. The tools that any sequence
/// uses are a path through it that takes no longer than the sequence [costs.md, 'The lower bound']. Without
/// tools: nothing is known.
struct LeastTimes {
    std::vector<std::string> tools;
    /// [1 + m][k]: of tool k after tool m, or of k as the first where m is kSource.
    std::vector<std::vector<double>> cutting_s;
    std::vector<bool> ends;  ///< the last tool may be this one

    double cuttingS(int m, int k) const { return cutting_s[m + 1][k]; }
};

}  // namespace stepmill
