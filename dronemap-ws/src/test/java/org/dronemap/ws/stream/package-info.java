/** The stream's parts by themselves. */
@NullMarked
package org.dronemap.ws.stream;

import org.jspecify.annotations.NullMarked;
