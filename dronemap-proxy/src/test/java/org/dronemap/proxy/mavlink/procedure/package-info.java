@NullMarked
package org.dronemap.proxy.mavlink.procedure;

import org.jspecify.annotations.NullMarked;
