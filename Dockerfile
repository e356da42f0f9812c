# The environment of continuous integration: Debian 12 with all packages that ./test needs. docker build -t brdf . && docker run -v "$PWD":/brdf brdf ./test
FROM debian:12
COPY tools/setup /setup/
COPY tools/packages /setup/packages
RUN apt-get update && apt-get install -y --no-install-recommends git ca-certificates g++ && /setup/setup build test && \
    rm -rf /var/lib/apt/lists/* && git config --system --add safe.directory /brdf
WORKDIR /brdf
