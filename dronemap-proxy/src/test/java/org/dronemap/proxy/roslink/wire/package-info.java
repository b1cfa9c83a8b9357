@NullMarked
package org.dronemap.proxy.roslink.wire;

import org.jspecify.annotations.NullMarked;
