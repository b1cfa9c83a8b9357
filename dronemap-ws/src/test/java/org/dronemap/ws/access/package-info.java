/** Tests of what handlers say of who may call them. */
@NullMarked
package org.dronemap.ws.access;

import org.jspecify.annotations.NullMarked;
