# SPDX-License-Identifier: MIT
# A Conan 2 recipe for the clone that contains this file: `conan create packages/conan`.
import os
import re

from conan import ConanFile
from conan.tools.cmake import CMake, CMakeToolchain, cmake_layout
from conan.tools.files import copy, load


class Detent(ConanFile):
    name = 'detent'
    license = 'MIT'
    description = ('Correctly rounded collision queries, scenes and worlds with the same bits on '
                   'every machine')
    settings = 'os', 'compiler', 'build_type', 'arch'

    @property
    def clone(self):
        return os.path.join(self.recipe_folder, '..', '..')

    def set_version(self):
        text = load(self, os.path.join(self.clone, 'include/detent/version.hpp'))
        self.version = '.'.join(re.findall(r'#define DETENT_VERSION_\w+ (\d+)', text))

    def export_sources(self):
        for pattern in ('CMakeLists.txt', 'LICENSE', 'include/*', 'src/*', 'packages/*'):
            copy(self, pattern, self.clone, self.export_sources_folder)

    def layout(self):
        cmake_layout(self)

    def generate(self):
        toolchain = CMakeToolchain(self)
        for option in ('TESTS', 'TOOL', 'DEMO'):
            toolchain.cache_variables[f'DETENT_BUILD_{option}'] = False
        toolchain.cache_variables['DETENT_WARNINGS_AS_ERRORS'] = False
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        CMake(self).install()

    def package_info(self):
        # The installed CMake config file defines the targets, so Conan writes none.
        self.cpp_info.set_property('cmake_find_mode', 'none')
        self.cpp_info.builddirs = [os.path.join('lib', 'cmake', 'detent')]
