/** Tests of what the environment sets. */
@NullMarked
package org.dronemap.ws.setting;

import org.jspecify.annotations.NullMarked;
