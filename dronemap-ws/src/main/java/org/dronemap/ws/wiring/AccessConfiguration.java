package org.dronemap.ws.wiring;

import org.dronemap.ws.access.HandlerMatchInterceptor;
import org.dronemap.ws.access.RestOperations;
import org.springframework.beans.factory.ObjectProvider;
import org.springframework.context.annotation.Bean;
import org.springframework.context.annotation.Configuration;
import org.springframework.web.servlet.config.annotation.InterceptorRegistry;
import org.springframework.web.servlet.config.annotation.WebMvcConfigurer;
import org.springframework.web.servlet.mvc.method.annotation.RequestMappingHandlerMapping;

/** Spring configuration of the access rules of REST handlers; the start fails if one declares none. */
@Configuration(proxyBeanMethods = false)
class AccessConfiguration {
    @Bean
    RestOperations restOperations(ObjectProvider<RequestMappingHandlerMapping> dispatcher) {
        return new RestOperations(() -> dispatcher.getObject().getHandlerMethods());
    }

    @Bean
    WebMvcConfigurer sameHandler(RestOperations operations) {
        return new WebMvcConfigurer() {
            @Override
            public void addInterceptors(InterceptorRegistry registry) {
                registry.addInterceptor(new HandlerMatchInterceptor(operations));
            }
        };
    }
}
