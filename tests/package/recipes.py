# SPDX-License-Identifier: MIT
# usage: recipes.py BUILD VERSION
"""Runs the vcpkg port and the Conan recipe with stand-ins for the functions of both tools, because
Debian has neither. The port must leave its files where vcpkg wants them, and the recipe must export
what CMake needs. The programs of both READMEs are then built with the CMake lines of the port's
usage and of Conan's README."""
import glob
import importlib.util
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import types

build, version = sys.argv[1:]
options = open('CMakeLists.txt', encoding='utf-8').read()

PORT = r'''
set(CURRENT_PACKAGES_DIR "@packages@")
set(CURRENT_PORT_DIR "@port@")
set(PORT detent)
function(vcpkg_cmake_configure)
  cmake_parse_arguments(PARSE_ARGV 0 given "" "SOURCE_PATH" "OPTIONS")
  if(NOT EXISTS "${given_SOURCE_PATH}/CMakeLists.txt" OR given_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "vcpkg_cmake_configure: ${ARGN}")
  endif()
  foreach(option IN LISTS given_OPTIONS)
    message(STATUS "option ${option}")
  endforeach()
endfunction()
function(vcpkg_cmake_install)
  execute_process(COMMAND ${CMAKE_COMMAND} --install "@build@" --prefix "${CURRENT_PACKAGES_DIR}"
                  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
endfunction()
function(vcpkg_cmake_config_fixup)
  cmake_parse_arguments(PARSE_ARGV 0 given "" "CONFIG_PATH" "")
  if(NOT EXISTS "${CURRENT_PACKAGES_DIR}/${given_CONFIG_PATH}/detent-config.cmake")
    message(FATAL_ERROR "no detent-config.cmake in ${given_CONFIG_PATH}")
  endif()
endfunction()
function(vcpkg_fixup_pkgconfig)
  if(NOT EXISTS "${CURRENT_PACKAGES_DIR}/lib/pkgconfig/detent.pc")
    message(FATAL_ERROR "no detent.pc")
  endif()
endfunction()
function(vcpkg_install_copyright)
  cmake_parse_arguments(PARSE_ARGV 0 given "" "" "FILE_LIST")
  file(COPY ${given_FILE_LIST} DESTINATION "${CURRENT_PACKAGES_DIR}/share/detent")
endfunction()
include("@port@/portfile.cmake")
'''


def vcpkg(work):
    port = os.path.abspath('packages/vcpkg/detent')
    manifest = json.load(open(os.path.join(port, 'vcpkg.json'), encoding='utf-8'))
    assert manifest['name'] == os.path.basename(port) and manifest['version'] == version
    script = PORT
    for name, value in (('packages', os.path.join(work, 'vcpkg')), ('port', port),
                        ('build', os.path.abspath(build))):
        script = script.replace(f'@{name}@', value)
    path = os.path.join(work, 'port.cmake')
    open(path, 'w', encoding='utf-8').write(script)
    said = subprocess.run(['cmake', '-P', path], check=True, capture_output=True, text=True).stdout
    given = [line.split('-D', 1)[1].split('=')[0] for line in said.splitlines() if '-D' in line]
    assert given and all(f'option({name} ' in options for name in given), given
    assert os.path.exists(os.path.join(work, 'vcpkg/share/detent/LICENSE'))
    # A project with the lines of the port's usage and the README's programs.
    root = os.path.join(work, 'vcpkg')
    with open(os.path.join(root, 'share/detent/usage'), encoding='utf-8') as file:
        usage = re.findall('^    (.*)', file.read(), re.M)
    assert len(usage) == 4, usage
    with open(os.path.join(root, 'share/doc/detent/README.md'), encoding='utf-8') as file:
        text = file.read()
    for name, source, lines in (('cpp', 'main.cpp', usage[:2]), ('c', 'main.c', usage[2:])):
        project = '\n'.join(['cmake_minimum_required(VERSION 3.23)', 'project(user LANGUAGES C CXX)',
                             lines[0], f'add_executable(main {source})', lines[1]])
        program = re.search(f'^```{name}\n(.*?)^```', text, re.M | re.S)[1]
        run_project(os.path.join(work, name), {source: program, 'CMakeLists.txt': project}, root, 'main')


def run_project(folder, files, root, target):
    """Builds a project against an installation root and compares its output."""
    os.makedirs(folder)
    for name, content in files.items():
        with open(os.path.join(folder, name), 'w', encoding='utf-8') as file:
            file.write(content + '\n')
    for command in (['-S', folder, '-B', folder, f'-DCMAKE_PREFIX_PATH={root}',
                     '-DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF'], ['--build', folder]):
        done = subprocess.run(['cmake', *command], capture_output=True, text=True)
        assert done.returncode == 0, done.stdout + done.stderr
    said = subprocess.run([os.path.join(folder, target)], check=True, capture_output=True, text=True).stdout
    assert said == 'a ball at 9\n', said


def conan(work):
    """Runs the recipe with the few functions of Conan that it uses."""
    root = os.path.join(work, 'conan_package')

    def copy(_, pattern, source, target):
        for path in glob.glob(os.path.join(source, pattern)):
            to = os.path.join(target, os.path.relpath(path, source))
            os.makedirs(os.path.dirname(to), exist_ok=True)
            if os.path.isdir(path):
                shutil.copytree(path, to)
            else:
                shutil.copy(path, to)

    class Toolchain:
        def __init__(self, _):
            self.cache_variables = {}

        def generate(self):
            assert all(f'option({name} ' in options for name in self.cache_variables)

    class CMake:
        def __init__(self, _):
            pass

        def configure(self):
            pass
        build = configure

        def install(self):
            subprocess.run(['cmake', '--install', build, '--prefix', root], check=True,
                           stdout=subprocess.DEVNULL)

    modules = {'conan': {'ConanFile': object}, 'conan.tools': {},
               'conan.tools.cmake': {'CMake': CMake, 'CMakeToolchain': Toolchain,
                                     'cmake_layout': lambda _: None},
               'conan.tools.files': {'copy': copy, 'load': lambda _, path: open(path).read()}}
    for name, members in modules.items():
        sys.modules[name] = types.ModuleType(name)
        vars(sys.modules[name]).update(members)
    spec = importlib.util.spec_from_file_location('conanfile', 'packages/conan/conanfile.py')
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    recipe = module.Detent()
    recipe.recipe_folder = os.path.abspath('packages/conan')
    recipe.export_sources_folder = os.path.join(work, 'conan')
    recipe.cpp_info = types.SimpleNamespace(set_property=lambda *_: None)
    recipe.set_version()
    assert recipe.version == version, recipe.version
    for step in ('export_sources', 'layout', 'generate', 'build', 'package', 'package_info'):
        getattr(recipe, step)()
    assert recipe.cpp_info.builddirs == ['lib/cmake/detent']
    with open('packages/conan/README.md', encoding='utf-8') as file:
        blocks = dict(re.findall('^```(\\w+)\n(.*?)^```', file.read(), re.M | re.S))
    run_project(os.path.join(work, 'conan_user'), {'main.cpp': blocks['cpp'], 'CMakeLists.txt': blocks['cmake']},
                os.path.join(root, recipe.cpp_info.builddirs[0]), 'game')
    # The exported files must configure without the rest of the repository.
    subprocess.run(['cmake', '-S', os.path.join(work, 'conan'), '-B', os.path.join(work, 'configured'),
                    '-DDETENT_BUILD_TESTS=OFF', '-DDETENT_BUILD_TOOL=OFF', '-DDETENT_BUILD_DEMO=OFF'],
                   check=True, stdout=subprocess.DEVNULL)


sys.dont_write_bytecode = True
with tempfile.TemporaryDirectory() as folder:
    vcpkg(folder)
    conan(folder)
print('the recipes of vcpkg and Conan do their steps')
