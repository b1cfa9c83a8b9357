package org.dronemap.ws.access;

import java.util.List;
import java.util.stream.Stream;
import org.springframework.beans.factory.support.RootBeanDefinition;
import org.springframework.context.annotation.ClassPathScanningCandidateComponentProvider;
import org.springframework.context.support.GenericApplicationContext;
import org.springframework.core.type.filter.AnnotationTypeFilter;
import org.springframework.util.ClassUtils;
import org.springframework.web.bind.annotation.RestController;
import org.springframework.web.servlet.mvc.method.annotation.RequestMappingHandlerMapping;

/** The operations of controllers as the web framework maps them, without a server and without the controllers' services. */
public final class HandlerCatalogue {
    private HandlerCatalogue() {}

    static RestOperations of(Class<?>... controllers) {
        GenericApplicationContext context = new GenericApplicationContext();
        for (Class<?> controller : controllers) {
            RootBeanDefinition named = new RootBeanDefinition(controller);
            named.setLazyInit(true);
            context.registerBeanDefinition(controller.getName(), named);
        }
        context.refresh();
        RequestMappingHandlerMapping mapping = new RequestMappingHandlerMapping();
        mapping.setApplicationContext(context);
        mapping.afterPropertiesSet();
        return new RestOperations(mapping::getHandlerMethods);
    }

    /** All that ship. */
    public static List<RestOperation> all() {
        var scanner = new ClassPathScanningCandidateComponentProvider(false);
        scanner.addIncludeFilter(new AnnotationTypeFilter(RestController.class));
        Class<?>[] controllers = scanner.findCandidateComponents("org.dronemap.ws").stream()
                .flatMap(found -> Stream.ofNullable(found.getBeanClassName()))
                .filter(name -> !name.startsWith("org.dronemap.ws.violation."))
                .map(name -> ClassUtils.resolveClassName(name, HandlerCatalogue.class.getClassLoader()))
                .toArray(Class<?>[]::new);
        return of(controllers).all();
    }
}
