// Where the images that a model of the air reads begin, in each pass that is compiled with the models: `air`, `air_repair`, `lighting`.
#ifndef ALPENGLOW_INTEROP_AIR_MODEL_H
#define ALPENGLOW_INTEROP_AIR_MODEL_H

#define AIR_MODEL_SLOT 16 // this and the next: interop/models/NAME.h

#endif
