#pragma once
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace brewster {

/// A file of tests/optics/reference: named columns, one row a case, truth from 50-digit arithmetic.
class ReferenceTable {
  public:
    explicit ReferenceTable(const std::string& name) : name_(name) {
        std::ifstream file(std::string(BREWSTER_SOURCE_DIR) + "/tests/optics/reference/" + name + ".json");
        const nlohmann::json table = nlohmann::json::parse(file);
        columns_ = table["columns"].get<std::vector<std::string>>();
        rows_ = table["rows"].get<std::vector<std::vector<nlohmann::json>>>();
    }

    std::size_t size() const { return rows_.size(); }
    double operator()(std::size_t row, const std::string& column) const {
        return rows_[row][index(column)].get<double>();
    }
    std::string text(std::size_t row, const std::string& column) const {
        return rows_[row][index(column)].get<std::string>();
    }
    const std::string& name() const { return name_; }

  private:
    std::size_t index(const std::string& column) const {
        const auto found = std::find(columns_.begin(), columns_.end(), column);
        if (found == columns_.end()) throw std::out_of_range(name_ + " has no column " + column);
        return static_cast<std::size_t>(found - columns_.begin());
    }

    std::string name_;
    std::vector<std::string> columns_;
    std::vector<std::vector<nlohmann::json>> rows_;
};

/// Worst errors of each column against its truth, printed when the test ends.
class WorstErrors {
  public:
    explicit WorstErrors(std::string title) : title_(std::move(title)) {}
    ~WorstErrors() {
        for (const auto& [column, worst] : worst_)
            std::printf("worst  %-24s %-16s %s %.2e (row %zu)\n", title_.c_str(), column.c_str(),
                        worst.relative ? "relative" : "absolute", worst.error, worst.row);
    }
    WorstErrors(const WorstErrors&) = delete;
    WorstErrors& operator=(const WorstErrors&) = delete;

    /// |value - truth| / |truth|; a truth of zero asks for zero.
    void relative(const std::string& column, std::size_t row, double value, double truth) {
        const double difference = std::abs(value - truth);
        note(column, row, difference == 0 ? 0 : difference / std::abs(truth), true);
    }
    void absolute(const std::string& column, std::size_t row, double value, double truth) {
        note(column, row, std::abs(value - truth), false);
    }

    double worst(const std::string& column) const { return worst_.at(column).error; }
    double worst() const {
        double all = 0;
        for (const auto& [column, entry] : worst_) all = std::max(all, entry.error);
        return all;
    }

  private:
    struct Entry {
        double error = 0;
        std::size_t row = 0;
        bool relative = true;
    };

    void note(const std::string& column, std::size_t row, double error, bool relative) {
        Entry& entry = worst_[column];
        entry.relative = relative;
        if (!(error <= entry.error)) entry = {std::isnan(error) ? INFINITY : error, row, relative};
    }

    std::string title_;
    std::map<std::string, Entry> worst_;
};

}  // namespace brewster
