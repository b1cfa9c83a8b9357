package org.dronemap.ws.reading;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/** Declares the enum whose constants, as {@link WireNames#camel} writes them, are allowed in a text of the API. */
@Target(ElementType.RECORD_COMPONENT)
@Retention(RetentionPolicy.RUNTIME)
public @interface EnumValues {
    Class<? extends Enum<?>> value();

    /** Further values. */
    String[] and() default {};
}
