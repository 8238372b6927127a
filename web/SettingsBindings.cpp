// The table of settings: in the programs that draw and in the core's.
#include "Boundary.h"
#include "settings/Settings.h"

using namespace fur;

FUR_EXPORT const char* fur_settingsTable() { return web::text(settings::fieldTableJson()); }
