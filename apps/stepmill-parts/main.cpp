// Writes the sample parts as STEP files: stepmill-parts OUT_DIR

#include <filesystem>
#include <iostream>

#include "sample_parts.h"
#include "stepmill/core/error.h"
#include "stepmill/core/file.h"

int main(int argc, char** argv) {
    if (argc != 2 || std::string(argv[1]).starts_with("-")) {
        std::cerr << "usage: stepmill-parts OUT_DIR\nwrites Stepmill's sample parts as STEP files\n";
        return 2;
    }
    try {
        const std::filesystem::path folder = argv[1];
        std::error_code failed;
        std::filesystem::create_directories(folder, failed);
        if (failed) throw stepmill::Error(stepmill::ErrorCode::OutputUnwritable, argv[1], failed.message());
        const std::vector<stepmill::SamplePart> parts = stepmill::allSampleParts();
        for (const stepmill::SamplePart& part : parts) {
            const std::string bytes = stepmill::sampleStepText(part);
            stepmill::writeFile(folder / (part.name + ".step"), bytes);
            std::cout << part.name << ".step  " << bytes.size() << " bytes\n";
        }
        stepmill::writeFile(folder / "README.md", stepmill::sampleReadme(parts));
    } catch (const stepmill::Error& error) {
        std::cerr << "stepmill-parts: " << error.what() << '\n';
        return stepmill::isInputError(error.code()) ? 2 : 3;
    }
    return 0;
}
