@NullMarked
package org.dronemap.proxy.roslink;

import org.jspecify.annotations.NullMarked;
