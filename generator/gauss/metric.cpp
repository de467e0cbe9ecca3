#include "gauss/metric.hpp"

namespace gaussgen::gauss {

namespace {

template <class Index>
std::vector<std::string> labels(const std::vector<Index>& indices, const Chart& chart) {
  std::vector<std::string> result;
  for (const Index i : indices) result.push_back(chart[i].label);
  return result;
}

template <class Index>
Table<Index, Index> inverse(const std::string& name, const Table<Index, Index>& table,
                            const std::vector<Index>& indices, const Chart& chart, symbolic::Bindings& bindings) {
  symbolic::Matrix matrix;
  for (const auto& row : table) matrix.push_back(row.values());
  const std::vector<std::string> names = labels(indices, chart);
  Table<Index, Index> result;
  for (const std::vector<ex>& row : bindings.invert(name, names, names, matrix, true))
    result.push_back(Row<Index>(row));
  return result;
}

template <class RowIndex, class ColumnIndex>
Table<RowIndex, ColumnIndex> block(const Table<FullIndex, FullIndex>& full, const Chart& chart,
                                   const std::vector<RowIndex>& rows, const std::vector<ColumnIndex>& columns) {
  auto result = symbolic::zero_table<RowIndex, ColumnIndex>(rows.size(), columns.size());
  for (const RowIndex i : rows) {
    for (const ColumnIndex j : columns) result[i][j] = full[chart.full(i)][chart.full(j)];
  }
  return result;
}

Table<HeldIndex, HeldIndex> schur_complement(const Metric& metric, const Chart& chart) {
  auto E_xx = metric.G_xx;
  for (const HeldIndex i : chart.held()) {
    for (const HeldIndex j : chart.held()) {
      for (const FreeIndex a : chart.free()) {
        for (const FreeIndex b : chart.free()) E_xx[i][j] -= metric.G_qx[a][i] * metric.g_up[a][b] * metric.G_qx[b][j];
      }
    }
  }
  return E_xx;
}

}  // namespace

Metric metric(const KineticForm& form, const Chart& chart, symbolic::Bindings& bindings) {
  Metric result;
  result.G = form.G;
  for (auto& row : result.G) {
    for (ex& entry : row) entry = chart.at_attitude(entry);
  }
  result.G_qq = block(result.G, chart, chart.free(), chart.free());
  result.G_qx = block(result.G, chart, chart.free(), chart.held());
  result.G_xx = block(result.G, chart, chart.held(), chart.held());
  result.g_up = inverse("g_up", result.G_qq, chart.free(), chart, bindings);
  result.G_up = inverse("G_up", result.G, chart.all(), chart, bindings);
  result.E_xx = schur_complement(result, chart);
  result.E_xx_up = block(result.G_up, chart, chart.held(), chart.held());
  return result;
}

}  // namespace gaussgen::gauss
