# Installs what `build` has to one folder and moves it to another, `to`: an installed copy knows no path of its own.
file(REMOVE_RECURSE "${to}" "${to}-first")
execute_process(COMMAND ${CMAKE_COMMAND} --install "${build}" --prefix "${to}-first" OUTPUT_QUIET
                COMMAND_ERROR_IS_FATAL ANY)
file(RENAME "${to}-first" "${to}")
