# SPDX-License-Identifier: Apache-2.0
# The folders of src/ from the lowest to the highest. A file may include files of its own folder and of
# folders before it in this list; tests/harness/check_layers.py checks the includes and docs/flow.md.
set(KERF_LAYERS
  core parallel kernels materials fracture model geometry machine input
  simd particles neighbours distributed pairs solid fluid contact time
  simulation shinohara2004 standard engine
  analysis output report verification study app library python)

# Creates a folder for the include path of the compiler: links to the folder `name` of src/ and to the
# folders below it.
function(kerf_layer_folder name result)
  set(folder ${CMAKE_BINARY_DIR}/layers/${name})
  list(FIND KERF_LAYERS ${name} last)
  foreach(number RANGE ${last})
    list(GET KERF_LAYERS ${number} below)
    if(NOT EXISTS ${folder}/${below})
      file(MAKE_DIRECTORY ${folder})
      file(CREATE_LINK ${CMAKE_SOURCE_DIR}/src/${below} ${folder}/${below} SYMBOLIC)
    endif()
  endforeach()
  set(${result} ${folder} PARENT_SCOPE)
endfunction()

# kerf_engine_sources(result [names...]) generates one source for each engine, so that they build in
# parallel: every formulation in 2D and 3D, in mixed and double precision. With names, such as
# standard_2d_mixed, only those engines are compiled, and the sources of the others refuse the run.
function(kerf_engine_sources result)
  set(CLASS_shinohara2004 Shinohara2004)
  set(CLASS_standard Standard)
  set(PRECISION_mixed Mixed)
  set(PRECISION_double Double)
  set(folder ${CMAKE_BINARY_DIR}/generated/engine)
  set(sources)
  foreach(FORMULATION shinohara2004 standard)
    foreach(DIMENSION 2 3)
      foreach(precision mixed double)
        set(NAME ${FORMULATION}_${DIMENSION}d_${precision})
        set(CLASS ${CLASS_${FORMULATION}})
        set(PRECISION ${PRECISION_${precision}})
        set(kind instantiate)
        if(ARGN AND NOT NAME IN_LIST ARGN)
          set(kind left_out)
        endif()
        configure_file(${CMAKE_SOURCE_DIR}/src/engine/${kind}.cpp.in ${folder}/${kind}_${NAME}.cpp @ONLY)
        list(APPEND sources ${folder}/${kind}_${NAME}.cpp)
      endforeach()
    endforeach()
  endforeach()
  set(${result} ${sources} PARENT_SCOPE)
endfunction()
