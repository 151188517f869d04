// SPDX-License-Identifier: MIT
// Costs as a table: passes down, GPUs across.
#include "tools/measure/cost/cost.h"

#include "core/base/numbers.h"
#include "tools/show/plan/names.h"

#include <algorithm>

namespace crevice {

namespace {

using Row = std::vector<std::string>;

constexpr double kMebibyte = 1 << 20;

/// Columns of the table before those of the GPUs; the two last only where there is one GPU.
Row passColumns(bool detailed)
{
    Row names = {"pass", "px", "fetches", "MiB"};
    if (detailed) names.insert(names.end(), {"read", "size"});
    return names;
}

/// The columns of one GPU: those that its compiler tells. All of them where it is the only one.
struct Columns {
    const CostGpu* gpu;
    bool detailed;

    Row names() const
    {
        Row names = {"inst", "sp:fi", "occ"};
        if (!gpu->units.empty()) names.push_back("cyc");
        if (gpu->disassembled) names.push_back("16b");
        if (!detailed) return names;
        names.insert(names.end(), gpu->units.begin(), gpu->units.end());
        if (*gpu->registers) names.push_back("regs");
        names.push_back("bytes");
        if (gpu->disassembled) names.insert(names.end(), {"half", "ALU"});
        return names;
    }
};

std::string threadsText(const CostGpu& gpu, int threads)
{
    return std::to_string(threads) + "/" + std::to_string(gpu.most_threads);
}

std::string shareText(int half, int all)
{
    return all > 0 ? fixed(100.0 * half / all, 0) + "%" : "-";
}

std::string cyclesText(double cycles)
{
    return cycles < 0 ? "-" : cycles < 99.95 ? fixed(cycles, 1) : fixed(cycles, 0);
}

void addDetails(const CostGpu& gpu, const CompilerFigures& figures, Row& cells)
{
    for (const double cycles : figures.unit_cycles) cells.push_back(cyclesText(cycles));
    if (*gpu.registers) cells.push_back(std::to_string(figures.registers));
    cells.push_back(std::to_string(figures.code_bytes));
    if (!gpu.disassembled) return;
    cells.push_back(std::to_string(figures.half_arithmetic));
    cells.push_back(std::to_string(figures.arithmetic));
}

Row cellsOf(const Columns& columns, const CompilerFigures& figures)
{
    const CostGpu& gpu = *columns.gpu;
    if (!figures.refusal.empty()) {
        Row cells(columns.names().size(), "-");
        cells[0] = "refused";
        return cells;
    }
    Row cells = {std::to_string(figures.instructions),
                 std::to_string(figures.spills) + ":" + std::to_string(figures.fills),
                 threadsText(gpu, figures.threads)};
    if (!gpu.units.empty()) cells.push_back(cyclesText(figures.cycles));
    if (gpu.disassembled) cells.push_back(shareText(figures.half_arithmetic, figures.arithmetic));
    if (columns.detailed) addDetails(gpu, figures, cells);
    return cells;
}

Row cellsOf(const Columns& columns, const GpuSum& sum)
{
    const CostGpu& gpu = *columns.gpu;
    Row cells = {std::to_string(sum.instructions) + (sum.refused ? "+" : ""),
                 std::to_string(sum.spills) + ":" + std::to_string(sum.fills),
                 threadsText(gpu, sum.threads)};
    if (!gpu.units.empty()) cells.push_back(cyclesText(sum.cycles));
    if (gpu.disassembled) cells.push_back(shareText(sum.half_arithmetic, sum.arithmetic));
    const std::size_t count = columns.names().size();
    while (cells.size() < count) cells.push_back("");
    return cells;
}

void addCells(Row& row, Row cells)
{
    row.insert(row.end(), std::make_move_iterator(cells.begin()),
               std::make_move_iterator(cells.end()));
}

/// Lines of the table; an empty row is a line of its own text in `title`.
struct Line {
    std::string title;
    Row cells;
};

class Table {
public:
    explicit Table(const CostReport& report) : detailed_(report.gpus.size() == 1)
    {
        for (const CostGpu* gpu : report.gpus) columns_.push_back({gpu, detailed_});
        Row names = passColumns(detailed_);
        for (const Columns& each : columns_) addCells(names, each.names());
        lines_.push_back({"", names});
    }

    void add(const PassCost& pass)
    {
        Row row = firstCells(pass.pass, fixed(pass.pixels, 2), pass.fetches, pass.bytes,
                             sizeText(pass.extent));
        for (std::size_t i = 0; i < columns_.size(); ++i)
            addCells(row, cellsOf(columns_[i], pass.figures[i]));
        lines_.push_back({"", std::move(row)});
    }

    void add(const std::string& name, const CostSum& sum)
    {
        Row row = firstCells(name, "", sum.fetches, sum.bytes, "");
        for (std::size_t i = 0; i < columns_.size(); ++i)
            addCells(row, cellsOf(columns_[i], sum.gpus[i]));
        lines_.push_back({"", std::move(row)});
    }

    void title(const std::string& text) { lines_.push_back({text, {}}); }

    std::string text() const
    {
        std::vector<std::size_t> widths;
        for (const Line& line : lines_)
            for (std::size_t i = 0; i < line.cells.size(); ++i) {
                if (widths.size() <= i) widths.push_back(0);
                widths[i] = std::max(widths[i], line.cells[i].size());
            }
        std::string all = gpuNames(widths);
        for (const Line& line : lines_) all += lineText(line, widths);
        return all;
    }

private:
    Row firstCells(const std::string& name, const std::string& pixels,
                   const std::optional<double>& fetches, const MovedBytes& bytes,
                   const std::string& size) const
    {
        Row row = {name, pixels, fetches ? fixed(*fetches, 2) : "-",
                   fixed((bytes.written + bytes.loaded) / kMebibyte, 2)};
        if (detailed_) addCells(row, {fixed((bytes.read - bytes.loaded) / kMebibyte, 2), size});
        return row;
    }

    /// Whether a GPU's columns begin there: a wider gap goes before them.
    bool begins(std::size_t column) const
    {
        std::size_t first = passColumns(detailed_).size();
        for (const Columns& each : columns_) {
            if (first == column) return true;
            first += each.names().size();
        }
        return false;
    }

    std::string lineText(const Line& line, const std::vector<std::size_t>& widths) const
    {
        if (line.cells.empty()) return line.title + "\n";
        std::string text;
        for (std::size_t i = 0; i < line.cells.size(); ++i) {
            const std::string padding(widths[i] - line.cells[i].size(), ' ');
            if (i > 0) text += begins(i) ? " | " : " ";
            text += i == 0 ? line.cells[i] + padding : padding + line.cells[i];
        }
        text.erase(text.find_last_not_of(' ') + 1);
        return text + "\n";
    }

    /// The line above the columns: each GPU's name where its columns begin.
    std::string gpuNames(const std::vector<std::size_t>& widths) const
    {
        std::string text;
        std::size_t at = 0, gpu = 0;
        for (std::size_t i = 0; i < widths.size(); ++i) {
            at += i == 0 ? 0 : begins(i) ? 3 : 1;
            if (begins(i)) {
                text.resize(at - 2, ' ');
                text += std::string("| ") + columns_[gpu++].gpu->name;
            }
            at += widths[i];
        }
        return text + "\n";
    }

    bool detailed_;
    std::vector<Columns> columns_;
    std::vector<Line> lines_;
};

void addPasses(Table& table, const ConfigCost& config, PassRole role)
{
    for (const PassCost& pass : config.passes)
        if (pass.role == role) table.add(pass);
}

bool hasPasses(const ConfigCost& config, PassRole role)
{
    return std::any_of(config.passes.begin(), config.passes.end(),
                       [&](const PassCost& pass) { return pass.role == role; });
}

std::string tableOf(const CostReport& report, const ConfigCost& config)
{
    Table table(report);
    addPasses(table, config, PassRole::ao);
    table.add("AO in all", sumOfAo(report, config, false));
    if (hasPasses(config, PassRole::geometry_for_ao) || config.geometry_bytes_for_ao > 0) {
        table.title("drawn for AO alone");
        addPasses(table, config, PassRole::geometry_for_ao);
        table.add("AO with that", sumOfAo(report, config, true));
    }
    if (hasPasses(config, PassRole::geometry) || hasPasses(config, PassRole::picture))
        table.title("not for AO alone");
    addPasses(table, config, PassRole::geometry);
    addPasses(table, config, PassRole::picture);
    return table.text();
}

std::string refusalsOf(const CostReport& report, const ConfigCost& config)
{
    std::string text;
    for (const PassCost& pass : config.passes)
        for (std::size_t i = 0; i < pass.figures.size(); ++i)
            if (!pass.figures[i].refusal.empty())
                text += std::string(report.gpus[i]->name) + " refuses " + pass.pass + ": " +
                        pass.figures[i].refusal + "\n";
    return text;
}

}  // namespace

std::string toText(const CostReport& report)
{
    std::string text;
    for (const ConfigCost& config : report.configs) {
        std::string set = report.variant.empty() ? "" : " --variant " + report.variant;
        for (const std::string& each : report.set) set += " " + each;
        text += config.config + set + ": " + report.scene + ", " + sizeText(report.extent) +
                ", compilers of " + report.version + "\n";
        text += tableOf(report, config);
        text += refusalsOf(report, config);
        if (!config.uncounted.empty()) text += "fetches not counted: " + config.uncounted + "\n";
        text += "\n";
    }
    return text +
           "Mend spills (sp:fi above 0:0) first, then occ below its most. cyc counts loops once, "
           "fetches "
           "as they run; both are for a pixel. See docs/reference/cost.md.\n";
}

}  // namespace crevice
