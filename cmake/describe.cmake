# cmake -D PROGRAM=brdf -D OUT=folder -D PAGE=file -P describe.cmake: man pages and completions, as the program itself writes
# them, and the page of brdf_check.
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE ${OUT})
file(MAKE_DIRECTORY ${OUT}/bash ${OUT}/zsh)
execute_process(COMMAND ${PROGRAM} describe man -o ${OUT}/man COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${PROGRAM} describe bash OUTPUT_FILE ${OUT}/bash/brdf COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${PROGRAM} describe zsh OUTPUT_FILE ${OUT}/zsh/_brdf COMMAND_ERROR_IS_FATAL ANY)
file(COPY ${PAGE} DESTINATION ${OUT}/man)
file(GLOB pages ${OUT}/man/*.1)
execute_process(COMMAND gzip -9n ${pages} COMMAND_ERROR_IS_FATAL ANY)
