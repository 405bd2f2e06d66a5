# The packages, made from this folder and installed on a Debian 12 that has nothing else:
#
#   docker build -t tautline .
#   docker run --rm -v "$PWD/results:/results" tautline          # the bench; then open results/index.html
#   docker run --rm tautline solve bouncing-ball
FROM debian:12 AS build
WORKDIR /tautline
COPY . .
RUN apt-get update && apt-get install -y --no-install-recommends ca-certificates git
RUN scripts/install-packages build engines package
RUN scripts/package /packages

FROM debian:12
COPY --from=build /packages /packages
RUN apt-get update && apt-get install -y --no-install-recommends /packages/*.deb && rm -rf /packages
WORKDIR /results
ENTRYPOINT ["tautline"]
CMD ["bench", "--out", "/results"]
