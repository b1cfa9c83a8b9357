/** Settings as the environment says them: read and checked once, when the server starts. */
@NullMarked
package org.dronemap.ws.setting;

import org.jspecify.annotations.NullMarked;
