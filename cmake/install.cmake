# `cmake --install build/release`: the program with its manual page and shell completion, and, as
# component "dev", the libraries with their headers for find_package(regarment).
# `cpack --config build/release/CPackConfig.cmake`: the same as a Debian package, without "dev".
include(CMakePackageConfigHelpers)

set(REGARMENT_SHARE ${CMAKE_BINARY_DIR}/share)
set(manual ${REGARMENT_SHARE}/man/man1/regarment.1)
set(bash ${REGARMENT_SHARE}/bash-completion/completions/regarment)
set(zsh ${REGARMENT_SHARE}/zsh/vendor-completions/_regarment)
set(fish ${REGARMENT_SHARE}/fish/vendor_completions.d/regarment.fish)
foreach(file ${manual} ${bash} ${zsh} ${fish})
  get_filename_component(folder ${file} DIRECTORY)
  file(MAKE_DIRECTORY ${folder})
endforeach()
# A sanitized or fuzzed program is not for installing.
if(NOT REGARMENT_SANITIZE AND NOT REGARMENT_FUZZ)
  add_custom_command(OUTPUT ${manual}.gz ${bash} ${zsh} ${fish}
    COMMAND regarment manual > ${manual}
    COMMAND gzip -9nf ${manual}
    COMMAND regarment completion bash > ${bash}
    COMMAND regarment completion zsh > ${zsh}
    COMMAND regarment completion fish > ${fish}
    DEPENDS regarment COMMENT "Writing the manual page and shell completion" VERBATIM)
  add_custom_target(shell_help ALL DEPENDS ${manual}.gz ${bash} ${zsh} ${fish})
  # What the program consists of, for those who must know what they install.
  set(sbom ${REGARMENT_SHARE}/doc/regarment/regarment.spdx.json)
  file(MAKE_DIRECTORY ${REGARMENT_SHARE}/doc/regarment)
  add_custom_command(OUTPUT ${sbom}
    COMMAND ${PROJECT_SOURCE_DIR}/scripts/sbom.py $<TARGET_FILE:regarment> ${PROJECT_VERSION} > ${sbom}
    DEPENDS regarment ${PROJECT_SOURCE_DIR}/scripts/sbom.py
    COMMENT "Writing the bill of materials" VERBATIM)
  add_custom_target(sbom ALL DEPENDS ${sbom})
endif()

install(TARGETS regarment RUNTIME COMPONENT program)
install(DIRECTORY ${REGARMENT_SHARE}/ DESTINATION ${CMAKE_INSTALL_DATAROOTDIR} COMPONENT program)
install(FILES README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
install(FILES examples/data/skirt-1.mesh.ply examples/data/skirt-1.mesh.labels.u8
  examples/data/ground_truth.csv examples/data/LICENSE-CC0.txt
  DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples COMPONENT program)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright COMPONENT program)

# The way from a file to an Analysis.
set(REGARMENT_LIBRARIES base geometry optim render scan garment placement measure segmentation drape
    fabric fit joint analysis)
install(TARGETS ${REGARMENT_LIBRARIES} regarment_options EXPORT regarment
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}/regarment COMPONENT dev)
foreach(library ${REGARMENT_LIBRARIES})
  install(DIRECTORY src/${library} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/regarment COMPONENT dev
    FILES_MATCHING PATTERN "*.h")
endforeach()
install(EXPORT regarment NAMESPACE regarment:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/regarment
  FILE regarment-targets.cmake COMPONENT dev)
configure_package_config_file(cmake/regarment-config.cmake.in
  ${CMAKE_BINARY_DIR}/regarment-config.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/regarment)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/regarment-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/regarment-config.cmake
  ${CMAKE_BINARY_DIR}/regarment-config-version.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/regarment COMPONENT dev)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME regarment)
set(CPACK_PACKAGE_VENDOR Regarment)
set(CPACK_PACKAGE_CONTACT "Regarment <regarment@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Flat garment dimensions from 3D scans of dressed people")
set(CPACK_PACKAGE_DESCRIPTION_FILE ${PROJECT_SOURCE_DIR}/cmake/package-description.txt)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_DIRECTORY ${CMAKE_BINARY_DIR})
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL program)
set(CPACK_COMPONENTS_GROUPING ALL_COMPONENTS_IN_ONE)
set(CPACK_DEBIAN_PACKAGE_NAME regarment)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
include(CPack)
