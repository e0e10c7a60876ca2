// SPDX-License-Identifier: Apache-2.0
// hexweave graph CONFIG -o PICTURE: the topology as resolved, drawn.
#include "commands/case_files.h"
#include "commands/case_options.h"
#include "commands/command.h"
#include "io/output_files.h"
#include "io/topology_picture.h"
#include "topology/resolve.h"

namespace hexweave {
namespace {

struct GraphOptions : CaseOptions {
    std::string output;
};

ExitCode graph(const GraphOptions& options, Outcome& outcome) {
    const PictureFormat format = picture_format(options.output);
    const Case written = read_case_of(options, outcome);
    require_apart({files_of_case(options, written), {{"-o", options.output}}}, options, outcome);
    const Topology topology = resolve(written, outcome.diagnostics);
    settle_warnings(outcome.diagnostics, options);
    const std::string title = topology.title.empty() ? options.config : topology.title;
    OutputFiles files;
    files.write(files.stage(options.output), [&](const std::filesystem::path& temporary) {
        draw_topology(topology, title, format, temporary);
    });
    files.commit();
    return ExitCode::done;
}

}  // namespace

void add_graph(CLI::App& app, ChosenCommand& chosen) {
    CLI::App* command = app.add_subcommand(
        "graph", "draw the topology of a config: vertices, edges, faces, blocks, boundaries");
    auto options = std::make_shared<GraphOptions>();
    command->add_option("CONFIG", options->config, "the YAML file; - reads standard input")
        ->required();
    command
        ->add_option("-o,--output", options->output,
                     "the drawing: a name that ends in .svg or .png")
        ->required();
    add_case_options(*command, *options);
    command->callback([options, &chosen] {
        chosen = [options] {
            return run_case_command("graph", *options, [options](Outcome& outcome) {
                return graph(*options, outcome);
            });
        };
    });
}

}  // namespace hexweave
