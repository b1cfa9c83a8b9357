/** Tests of what the environment sets. */
@NullMarked
package org.dronemap.ws.environment;

import org.jspecify.annotations.NullMarked;
