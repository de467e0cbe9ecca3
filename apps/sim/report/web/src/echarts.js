// The parts of Apache ECharts that the report draws with, and no others: half of the library stays out of the page.
export {init, use} from 'echarts/core';
import {use} from 'echarts/core';
import {BarChart, LineChart, ScatterChart} from 'echarts/charts';
import {GridComponent, MarkAreaComponent, MarkLineComponent, TitleComponent, TooltipComponent} from 'echarts/components';
import {SVGRenderer} from 'echarts/renderers';

use([BarChart, LineChart, ScatterChart, GridComponent, MarkAreaComponent, MarkLineComponent, TitleComponent,
  TooltipComponent, SVGRenderer]);
